// SPDX-License-Identifier: BSD-3-Clause
#include <toss/tracking/MotionEvidence.h>

#include <algorithm>
#include <cmath>

namespace toss {
namespace {

constexpr double kSmallestStep = 0.05;

/// Half the extent of the footprint along a horizontal unit vector.
double reachAlong(const Box& box, const Eigen::Vector2d& direction) {
  const double cosine = std::cos(box.yaw), sine = std::sin(box.yaw);
  return 0.5 * (box.length * std::abs(cosine * direction.x() + sine * direction.y()) +
                box.width * std::abs(cosine * direction.y() - sine * direction.x()));
}

}  // namespace

void MotionEvidence::add(const MotionObservation& observation) {
  const Eigen::Vector3d& center = observation.estimated.center;
  const Box& measured = observation.measured;
  if (hits_++ == 0) {
    firstTime_ = observation.time;
    first_ = last_ = center;
    firstMeasured_ = measured;
  }
  const double step = (center - last_).head<2>().norm();
  if (step >= kSmallestStep) pathLength_ += step;
  lastTime_ = observation.time;
  last_ = center;
  lastMeasured_ = measured;
  excursion_ = std::max(excursion_, displacement());
  jitter_ = observation.positionSd + 0.05;
  longestEdge_ = std::max({longestEdge_, measured.length, measured.width, measured.height});
  const auto extent = static_cast<float>(std::max(measured.length, measured.width));
  extents_.insert(std::upper_bound(extents_.begin(), extents_.end(), extent), extent);
}

double MotionEvidence::displacement() const {
  return (last_ - first_).head<2>().norm();
}

double MotionEvidence::medianExtent() const {
  return extents_.empty() ? 0.0 : static_cast<double>(extents_[extents_.size() / 2]);
}

double MotionEvidence::faceDisplacement() const {
  const Eigen::Vector2d apart = (lastMeasured_.center - firstMeasured_.center).head<2>();
  const double distance = apart.norm();
  if (!(distance > 0.0)) return 0.0;
  const Eigen::Vector2d direction = apart / distance;
  return distance -
         std::abs(reachAlong(lastMeasured_, direction) - reachAlong(firstMeasured_, direction));
}

}  // namespace toss
