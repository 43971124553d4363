// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

namespace toss {

/// Sorts `items` by their bits [lowBit, lowBit + bits), keeping the order of equal ones.
/// `buffer` is scratch space of any size.
void radixSort(std::vector<std::uint64_t>& items, int lowBit, int bits,
               std::vector<std::uint64_t>& buffer);

}  // namespace toss
