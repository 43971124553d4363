// SPDX-License-Identifier: BSD-3-Clause
#include "PoseNoise.h"

#include <cmath>

#include "Random.h"

namespace toss::simulation {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double kDegree = M_PI / 180.0;

/// Small rotation [rad per axis] and translation [m].
Isometry3d smallMotion(const Vector3d& rotation, const Vector3d& translation) {
  Isometry3d motion = Isometry3d::Identity();
  motion.translate(translation);
  const double angle = rotation.norm();
  if (angle > 0.0) motion.rotate(Eigen::AngleAxisd(angle, rotation / angle));
  return motion;
}

}  // namespace

Vector3d PoseNoise::random(std::uint64_t purpose) const {
  const std::uint64_t key = hash(hash(seed_, count_), purpose);
  return {gaussianOf(hash(key, 0)), gaussianOf(hash(key, 1)), gaussianOf(hash(key, 2))};
}

Isometry3d PoseNoise::report(const Isometry3d& exact) {
  if (factor_ == 0.0) return exact;
  if (count_ == 0) drifted_ = exact;
  const Isometry3d step = count_ == 0 ? Isometry3d::Identity() : previous_.inverse() * exact;
  const double root = factor_ * std::sqrt(step.translation().norm());
  const Vector3d turn = Vector3d(0.2, 0.2, 1.0).cwiseProduct(random(0));
  drifted_ = drifted_ * step * smallMotion(root * 0.02 * kDegree * turn, root * 0.01 * random(1));
  previous_ = exact;

  const Isometry3d jitter =
      smallMotion(factor_ * 0.03 * kDegree * random(2), factor_ * 0.01 * random(3));
  ++count_;
  return drifted_ * jitter;
}

}  // namespace toss::simulation
