// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/evaluation/LabelledCloud.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace toss {

/// Number of a cubic cell: floor(p / cellSize) per axis, x in the lowest 21 bits, then y, then z,
/// so that cells which are neighbours in x have neighbouring numbers.
using CellKey = std::uint64_t;

/// A cloud ordered by cell: what voxelising and every search for neighbours starts from.
struct CellOrder {
  /// Occupied cells, ascending, shape [cells].
  std::vector<CellKey> key;
  /// Places begin[c] .. begin[c + 1] - 1 hold the points of cell c, shape [cells + 1].
  std::vector<std::uint32_t> begin;
  /// Index in the cloud of the point at each place, ascending within a cell, shape [places].
  std::vector<std::uint32_t> index;
  /// Coordinates of the point at each place, shape [places].
  std::vector<float> x, y, z;

  std::size_t cells() const { return key.size(); }
  std::size_t places() const { return index.size(); }
};

/// Orders a cloud by cells of `cellSize` [m]. Points that are not finite or farther than 2^20 - 2
/// cells from the origin are left out.
void orderByCell(const LabelledCloud& cloud, double cellSize, CellOrder& result);

/// The places of `order` whose point has `bit` set in `membership` (shape: points of the cloud).
void selectMembers(const CellOrder& order, const std::vector<std::uint16_t>& membership,
                   std::uint16_t bit, CellOrder& result);

/// Key of the cell at offset (dx, dy, dz) of another, each in -1..1.
constexpr CellKey neighborKey(CellKey key, int dx, int dy, int dz) {
  const std::int64_t offset = dx + dy * (std::int64_t{1} << 21) + dz * (std::int64_t{1} << 42);
  return key + static_cast<CellKey>(offset);
}

/// First element of `keys` from `start` on that is not less than `wanted`, by doubling steps: cheap
/// where the answer lies near `start`.
std::size_t lowerBoundFrom(const std::vector<CellKey>& keys, std::size_t start, CellKey wanted);

/// Calls visit(cell of a, first place in b, end of places in b) for every run of places of `b` in
/// the 3x3x3 neighbourhood of every cell of `a`: every pair of points nearer than one cell size is
/// among them. Both must be ordered by cells of the same size.
template <typename Visit>
void joinCells(const CellOrder& a, const CellOrder& b, Visit&& visit) {
  std::array<std::size_t, 9> cursor{};
  for (std::size_t cell = 0; cell < a.cells(); ++cell) {
    std::size_t row = 0;
    for (int dz = -1; dz <= 1; ++dz) {
      for (int dy = -1; dy <= 1; ++dy, ++row) {
        const CellKey last = neighborKey(a.key[cell], 1, dy, dz);
        std::size_t first =
            lowerBoundFrom(b.key, cursor[row], neighborKey(a.key[cell], -1, dy, dz));
        cursor[row] = first;
        std::size_t end = first;
        while (end < b.cells() && b.key[end] <= last) ++end;
        if (end > first) visit(cell, b.begin[first], b.begin[end]);
      }
    }
  }
}

}  // namespace toss
