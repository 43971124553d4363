// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/Box.h>

#include <cstdint>
#include <utility>
#include <vector>

#include "ClaimFootprint.h"
#include "ScanRecord.h"

namespace toss {

/// The box of a trace in one scan, which claims returns.
struct Claimant {
  TrackId track = 0;
  /// Map frame [m].
  Box box;
  /// Whether it claims ground as well.
  bool ground = false;
};

/// A return of a scan that a box has claimed, and the number of the claimant.
struct Claim {
  std::int32_t point = 0, claimant = 0;
};

/// Finds what boxes claim of a scan: the returns that they hold when their sides and top are grown
/// by a margin, and what lies up to a metre under them, as the lowest part of an object may be in
/// the ground layer or too sparse to be in its instance. The smallest box that may have a return
/// has it.
class ClaimFinder {
 public:
  /// `margin` [m].
  explicit ClaimFinder(double margin) : margin_(static_cast<float>(margin)) {}

  /// Claims of all boxes, by ascending point; valid until the next are found. Looks at the returns
  /// of objects and of ground whose owner is not `moving`, shape [owners]; the record has its
  /// coordinates.
  const std::vector<Claim>& find(const std::vector<Claimant>& claimants, const ScanRecord& record,
                                 const std::vector<bool>& moving);

 private:
  /// Entry of a grid cell's list of boxes.
  struct Entry {
    std::int32_t box, next;
  };

  void enter(const std::vector<Claimant>& claimants, const Eigen::Vector3d& sensorPosition);
  /// Marks the squares that a box reaches, and lists it in their cells.
  void enter(const Claimant& claimant, std::int32_t number);
  /// Calls `visit(point)` for the returns in squares that a box reaches which claims such.
  template <typename Visit>
  void visitNearby(const ScanRecord& record, Visit&& visit) const;
  /// The smallest box that claims a point of the level frame, -1 = none.
  std::int32_t boxAround(const Eigen::Vector3f& point, bool ground) const;

  float margin_;
  /// Of each claimant.
  std::vector<ClaimFootprint> footprints_;
  std::vector<bool> takesGround_;
  /// Claimants, those with the largest boxes first.
  std::vector<std::pair<double, std::int32_t>> byVolume_;
  /// What boxes claim in each square of a ClaimGrid.
  std::vector<std::uint8_t> marks_;
  /// First entry of each cell of the grid, -1 = none; and cells that have entries.
  std::vector<std::int32_t> firstEntry_;
  std::vector<std::size_t> usedCells_;
  std::vector<Entry> entries_;
  std::vector<Claim> claims_;
};

}  // namespace toss
