// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <map>
#include <optional>

namespace toss {

/// Poses of the robot by time, for looking up the pose at the time of a scan.
class PoseBuffer {
 public:
  /// Time in MRPT's ticks of 100 ns.
  using Ticks = std::int64_t;

  /// `maxGap`: longest time between a scan and each of the two poses around it.
  explicit PoseBuffer(Ticks maxGap) : maxGap_(maxGap) {}

  /// Adds a pose (map <- robot), in any order of time; of several at one time the first stays.
  void add(Ticks time, const Eigen::Isometry3d& pose);
  /// The pose at `time`: the one that was added for it, bit for bit; else between the two around
  /// it, position linear and rotation by SLERP. None where one of the two is missing or too far.
  std::optional<Eigen::Isometry3d> at(Ticks time) const;
  /// The pose at `time` between two poses that are at most twice `maxGap` apart; beyond the first
  /// or last pose, as far as that, by the motion between the two that are nearest there.
  std::optional<Eigen::Isometry3d> around(Ticks time) const;
  /// Whether there is a pose at `time` or later.
  bool reaches(Ticks time) const { return !poses_.empty() && poses_.rbegin()->first >= time; }
  /// Whether a pose that makes at(time) succeed may still come, poses coming in order of time.
  bool mayStillCome(Ticks time) const;
  /// By ascending time.
  const std::map<Ticks, Eigen::Isometry3d>& all() const { return poses_; }
  /// Drops poses that are of no use for `time` and later.
  void forgetBefore(Ticks time);

 private:
  Ticks maxGap_;
  std::map<Ticks, Eigen::Isometry3d> poses_;
};

/// Position linear, rotation by SLERP; `share` = 0 gives `a`, 1 gives `b`, beyond them the motion
/// goes on.
Eigen::Isometry3d interpolate(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b, double share);

}  // namespace toss
