// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/Box.h>
#include <toss/segmentation/Segmentation.h>

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "NearbyReturns.h"

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

  /// Takes the boxes of a scan. `sensorPosition`: origin of the level frame in the map.
  void take(const std::vector<Claimant>& claimants, const Eigen::Vector3d& sensorPosition);
  /// Marks where returns lie that the boxes may claim.
  void markNearby(NearbyReturns& nearby) const;
  /// Replaces `claims` by those of all returns that were found nearby; the smallest box wins.
  /// `standing`: whether instance k may be cut, shape [instanceCount + 1].
  void find(const LevelPoints& points, const Segmentation& segmentation,
            const NearbyReturns& nearby, const std::vector<bool>& standing,
            std::vector<Claim>& claims);

  /// Smallest box that holds the point [m, level frame], leaving out the box of
  /// claimant `except`; -1 = none.
  std::int32_t boxAround(const Eigen::Vector3f& point, std::int32_t except) const;

 private:
  /// Upright box in the level frame, ready to be tested.
  struct Footprint {
    float x, y, cosYaw, sinYaw, halfLength, halfWidth, low, high;
    bool cutsInstances;

    /// The rectangle along the axes around it.
    Eigen::AlignedBox2f extent() const;
    /// Whether it holds a point of the level frame.
    bool holds(float px, float py, float pz) const;
  };
  /// Entry of a grid cell's list of boxes.
  struct Entry {
    std::int32_t box, next;
  };
  void enter(const Claimant& claimant, std::int32_t number, const Eigen::Vector3d& sensorPosition);
  void pickClaimable(const Segmentation& segmentation, const NearbyReturns& nearby,
                     const std::vector<bool>& standing);
  std::int32_t claimOf(float x, float y, float z, bool fromInstance, std::int32_t except) const;

  double margin_, residueHeight_;
  std::vector<Footprint> footprints_;
  /// First entry of each cell, -1 where there is none, shape [kCells * kCells].
  std::vector<std::int32_t> grid_;
  std::vector<Entry> entries_;
  /// Cells that have entries.
  std::vector<std::size_t> usedCells_;
  /// Returns that a box may claim.
  std::vector<std::int32_t> claimable_;
};

}  // namespace toss
