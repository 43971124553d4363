// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/mapping/VoxelKey.h>

#include <cstddef>

namespace toss {

/// Spreads keys that are near each other (Fibonacci hashing).
struct KeyHash {
  std::size_t operator()(VoxelKey key) const {
    return static_cast<std::size_t>((key * 0x9E3779B97F4A7C15ull) >> 24);
  }
};

}  // namespace toss
