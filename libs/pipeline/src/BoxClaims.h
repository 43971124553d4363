// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/Box.h>
#include <toss/segmentation/Segmentation.h>

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

namespace toss {

/// Finds the box that claims a return (spec sections 10.2, 10.3, 10.9 and 10.11): sparse returns,
/// the edges of an object, the feet and tyres that the ground took, and what has melted into a
/// standing instance that a moving trace passes.
class BoxClaims {
 public:
  /// A box that may claim returns.
  struct Claimant {
    /// Map frame [m].
    Box box;
    /// Whether it takes returns out of standing instances: a moving trace that was missed in this
    /// scan. Its box is taken without the margin then.
    bool cutsInstances = false;
  };

  /// `margin` [m]: growth of each box to its sides and top. `residueHeight` [m]: ground returns
  /// lower than this over the ground stay ground.
  BoxClaims(double margin, double residueHeight) : margin_(margin), residueHeight_(residueHeight) {}

  /// A return that a box has claimed: their numbers.
  struct Claim {
    std::int32_t point, claimant;
  };

  /// Replaces `claims` by those of all returns, outside instances first; the smallest box
  /// wins.
  /// `sensorPosition`: origin of the level frame in the map. `standing`: whether instance k may be
  /// cut, shape [instanceCount + 1].
  void find(const LevelPoints& points, const Segmentation& segmentation,
            const std::vector<Claimant>& claimants, const Eigen::Vector3d& sensorPosition,
            const std::vector<bool>& standing, std::vector<Claim>& claims);

  /// Smallest box of the last find() that holds the point [m, level frame], leaving out the box of
  /// claimant `except`; -1 = none.
  std::int32_t boxAround(const Eigen::Vector3f& point, std::int32_t except) const;

 private:
  /// Upright box in the level frame, ready to be tested.
  struct Footprint {
    float x, y, cosYaw, sinYaw, halfLength, halfWidth, low, high;
    bool cutsInstances;
  };
  /// Entry of a grid cell's list of boxes.
  struct Entry {
    std::int32_t box, next;
  };
  void enterAll(const std::vector<Claimant>& claimants, const Eigen::Vector3d& sensorPosition);
  void enter(const Claimant& claimant, std::int32_t number, const Eigen::Vector3d& sensorPosition);
  void collectOutsideInstances(const Segmentation& segmentation);
  void collectInInstances(const LevelPoints& points, const Segmentation& segmentation,
                          const std::vector<bool>& standing);
  std::int32_t claimOf(float x, float y, float z, bool fromInstance, std::int32_t except) const;

  double margin_, residueHeight_;
  std::vector<Footprint> footprints_;
  /// Holds all footprints that cut instances; level frame [m].
  Eigen::AlignedBox2f cutExtent_;
  /// First entry of each cell, -1 where there is none, shape [kCells * kCells].
  std::vector<std::int32_t> grid_;
  std::vector<Entry> entries_;
  /// Cells that have entries.
  std::vector<std::size_t> usedCells_;
  /// Returns that a box may claim.
  std::vector<std::int32_t> claimable_;
};

}  // namespace toss
