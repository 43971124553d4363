// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/segmentation/Segmentation.h>

#include <bitset>
#include <cstdint>
#include <vector>

#include "BoxClaims.h"

namespace toss {

/// Finds returns of the ground layer that touch the foot of an object: feet and tyres lie as low as
/// the ground beside them, and only their nearness to the body tells them apart (spec section 11.1,
/// the loss of feet, tyres and bumpers).
class GroundContact {
 public:
  /// An instance whose foot takes returns, and the claimant that gets them.
  struct Body {
    std::int32_t instance, claimant;
  };

  /// `distance` [m]: largest horizontal reach of a body's lowest half metre, which grows with
  /// range; 0 finds nothing.
  explicit GroundContact(double distance)
      : distance_(static_cast<float>(distance)), inverseDistance_(1.0 / distance) {}

  /// Takes the feet of a scan's bodies.
  void take(const LevelPoints& points, const Segmentation& segmentation,
            const std::vector<Body>& bodies);
  /// Marks where ground returns lie that the feet may touch.
  void markNearby(NearbyReturns& nearby) const;
  /// Replaces `claims` by every Ground return found nearby that is in reach of a body, by ascending
  /// point; the nearest body wins.
  void find(const LevelPoints& points, const Segmentation& segmentation,
            const NearbyReturns& nearby, std::vector<BoxClaims::Claim>& claims);

 private:
  static constexpr int kCells = 512;
  static constexpr std::size_t kTable = static_cast<std::size_t>(kCells) * kCells;
  /// A return of a body near the ground [m, level frame].
  struct FootPoint {
    float x, y, z;
    std::int32_t claimant;
  };
  int cellOf(float coordinate) const;
  void pickFeet(const Segmentation& segmentation);
  void enterPoint(const FootPoint& point);
  /// Number of a cell that gets a foot point; new ones are counted.
  std::int32_t enterCell(int row, int column);
  void sortByCell();
  /// Claimant of the nearest foot in reach of a ground return, -1 if there is none.
  std::int32_t nearest(float x, float y, float z) const;

  float distance_;
  double inverseDistance_;
  /// Foot points as they came, the one before it in its cell, and the last of each cell; -1 = none.
  std::vector<FootPoint> feet_;
  std::vector<std::int32_t> previous_, lastOfCell_;
  /// Foot points cell by cell; those of cell c begin at cellBegin_[c].
  std::vector<FootPoint> sorted_;
  std::vector<std::int32_t> cellBegin_;
  /// Number of the cell at each place, -1 where there are no feet; places repeat every kCells,
  /// shape [kTable].
  std::vector<std::int32_t> cellAt_;
  /// Place of each cell.
  std::vector<std::size_t> placeOfCell_;
  /// Body of each instance, -1 = none, shape [instanceCount + 1].
  std::vector<std::int32_t> bodyOf_;
  /// Extent of each body's feet; level frame [m].
  std::vector<Eigen::AlignedBox2f> extents_;
  /// Returns to be looked at closely; only grows, the first pickedCount_ count.
  std::vector<std::int32_t> picked_;
  std::size_t pickedCount_ = 0;
  /// Whether a foot point is in a cell or beside it.
  std::bitset<kTable> reached_;
};

}  // namespace toss
