// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace toss {

/// How a box may claim a return.
enum class ClaimWay : std::int32_t {
  Cut = 0,      ///< out of its instance
  Residue = 2,  ///< as residue at most: low ground
  Any = 3       ///< outright or as residue, as it is in no instance
};

/// Returns of a scan that boxes may claim, side by side and by ascending point, so that several are
/// looked at in one go. Keeps its memory from scan to scan.
struct ClaimReturns {
  /// Places behind the last return that may be read and written.
  static constexpr std::size_t kSpare = 8;

  std::size_t count = 0, stretchCount = 0;
  /// Shape [count].
  std::vector<std::int32_t> point;
  std::vector<ClaimWay> way;
  /// Cell of the grid that each lies in.
  std::vector<std::uint16_t> cell;
  /// Level frame [m].
  std::vector<float> x, y, z;
  /// First return of each stretch that lies in one cell, and the end of the last; shape
  /// [stretchCount + 1].
  std::vector<std::int32_t> stretch;

  /// Begins anew, with room for so many returns.
  void clear(std::size_t most) {
    count = stretchCount = 0;
    const std::size_t size = most + kSpare;
    if (point.size() >= size) return;
    point.resize(size), way.resize(size), cell.resize(size), stretch.resize(size);
    x.resize(size), y.resize(size), z.resize(size);
  }
};

}  // namespace toss
