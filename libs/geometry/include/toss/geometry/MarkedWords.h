// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace toss {

/// Marks that are looked at in one go.
constexpr std::size_t kMarksInWord = 8;

/// Calls `visit(first)` for each group of kMarksInWord marks, beginning at a multiple of that, of
/// which any is not 0. `marks`: shape [n], with n a multiple of kMarksInWord.
template <typename Visit>
void visitMarkedWords(const std::uint8_t* marks, std::size_t n, Visit&& visit) {
  for (std::size_t first = 0; first < n; first += kMarksInWord) {
    std::uint64_t any;
    std::memcpy(&any, marks + first, sizeof(any));
    if (any != 0) visit(first);
  }
}

/// Marks of which each is looked at by its bit.
constexpr std::size_t kMarksInBlock = 64;

/// Calls `visit(i)` for each i with marks[i] == 1, ascending; all other marks must be 0. `marks`:
/// shape [n], with n a multiple of kMarksInBlock. A choice for each mark would be mispredicted
/// more often.
template <typename Visit>
void visitMarks(const std::uint8_t* marks, std::size_t n, Visit&& visit) {
  // Brings the lowest bits of eight bytes together in the highest byte.
  constexpr std::uint64_t kPack = 0x0102040810204080u;
  for (std::size_t first = 0; first < n; first += kMarksInBlock) {
    std::uint64_t bits = 0;
    for (std::size_t byte = 0; byte < kMarksInBlock; byte += 8) {
      std::uint64_t word;
      std::memcpy(&word, marks + first + byte, sizeof(word));
      bits |= (word * kPack >> 56) << byte;
    }
    for (; bits != 0; bits &= bits - 1) {
      visit(first + static_cast<std::size_t>(__builtin_ctzll(bits)));
    }
  }
}

/// Length of marks that has room for `n`.
inline std::size_t roundedToBlocks(std::size_t n) {
  return (n + kMarksInBlock - 1) / kMarksInBlock * kMarksInBlock;
}

}  // namespace toss
