// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/Box.h>
#include <toss/segmentation/Segmentation.h>

#include <cstdint>
#include <vector>

namespace toss {

/// Finds, for returns that are in no instance, the box that claims them (spec sections 10.2, 10.3
/// and 10.9): sparse returns, the edges of an object, the feet and tyres that the ground took.
class BoxClaims {
 public:
  /// `margin` [m]: growth of each box to its sides and top. `residueHeight` [m]: ground returns
  /// lower than this over the ground stay ground.
  BoxClaims(double margin, double residueHeight) : margin_(margin), residueHeight_(residueHeight) {}

  /// Number of the claiming box for each return or -1, shape [n]; the smallest box wins. `boxes` in
  /// the map frame, `sensorPosition` the origin of the level frame there.
  void find(const LevelPoints& points, const Segmentation& segmentation,
            const std::vector<Box>& boxes, const Eigen::Vector3d& sensorPosition,
            std::vector<std::int32_t>& claimOfPoint);

 private:
  /// Upright box in the level frame, ready to be tested.
  struct Footprint {
    float x, y, cosYaw, sinYaw, halfLength, halfWidth, low, high;
  };
  /// Entry of a grid cell's list of boxes.
  struct Entry {
    std::int32_t box, next;
  };
  void enter(const Box& box, std::int32_t number, const Eigen::Vector3d& sensorPosition);
  bool isClaimable(const Segmentation& segmentation, std::size_t point) const;
  std::int32_t claimOf(float x, float y, float z) const;

  double margin_, residueHeight_;
  std::vector<Footprint> footprints_;
  std::vector<std::int32_t> grid_;
  std::vector<Entry> entries_;
};

}  // namespace toss
