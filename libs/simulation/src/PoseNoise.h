// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>

namespace toss::simulation {

/// Makes exact poses err as those of a LiDAR odometry: a drift that grows with the way travelled,
/// and a jitter from scan to scan.
class PoseNoise {
 public:
  /// `factor`: 0 = exact, 1 = realistic.
  PoseNoise(double factor, std::uint64_t seed) : factor_(factor), seed_(seed) {}

  /// The reported pose of the next scan, given the exact one. Takes the scans in order.
  Eigen::Isometry3d report(const Eigen::Isometry3d& exact);

 private:
  Eigen::Vector3d random(std::uint64_t purpose) const;

  double factor_;
  std::uint64_t seed_;
  std::uint64_t count_ = 0;
  Eigen::Isometry3d previous_ = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d drifted_ = Eigen::Isometry3d::Identity();
};

}  // namespace toss::simulation
