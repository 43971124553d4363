// SPDX-License-Identifier: BSD-3-Clause
#include "RadixSort.h"

#include <algorithm>

namespace toss {

namespace {

/// Digits of 11 bits: their 2048 counters stay in the first-level cache.
constexpr int kLargestDigit = 11;

void sortByDigit(const std::vector<std::uint64_t>& items, int lowBit, int bits,
                 std::vector<std::uint64_t>& sorted) {
  std::uint32_t place[1 << kLargestDigit] = {};
  const std::uint64_t mask = (std::uint64_t{1} << bits) - 1;
  for (const std::uint64_t item : items) ++place[item >> lowBit & mask];
  std::uint32_t sum = 0;
  for (std::uint64_t digit = 0; digit <= mask; ++digit) {
    const std::uint32_t count = place[digit];
    place[digit] = sum;
    sum += count;
  }
  for (const std::uint64_t item : items) sorted[place[item >> lowBit & mask]++] = item;
}

}  // namespace

void radixSort(std::vector<std::uint64_t>& items, int lowBit, int bits,
               std::vector<std::uint64_t>& buffer) {
  if (bits == 0) return;
  buffer.resize(items.size());
  const int passes = (bits + kLargestDigit - 1) / kLargestDigit;
  const int digit = (bits + passes - 1) / passes;
  for (int done = 0; done < bits; done += digit) {
    sortByDigit(items, lowBit + done, std::min(digit, bits - done), buffer);
    items.swap(buffer);
  }
}

}  // namespace toss
