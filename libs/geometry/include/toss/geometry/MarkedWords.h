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

}  // namespace toss
