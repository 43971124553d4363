// SPDX-License-Identifier: BSD-3-Clause
#include <toss/tracking/MotionEvidence.h>

#include <algorithm>
#include <numeric>

namespace toss {
namespace {

/// Shorter steps are jitter, whose sum would grow for ever.
constexpr double kSmallestStep = 0.05;

}  // namespace

void MotionEvidence::add(const MotionObservation& observation) {
  const Eigen::Vector3d& center = observation.estimated.center;
  const Box& measured = observation.measured;
  if (hits_++ == 0) first_ = last_ = center;
  const double step = (center - last_).head<2>().norm();
  if (step >= kSmallestStep) pathLength_ += step;
  last_ = center;
  excursion_ = std::max(excursion_, (center - first_).head<2>().norm());
  longestEdge_ = std::max({longestEdge_, measured.length, measured.width, measured.height});
  extents_.add(std::max(measured.length, measured.width));
  heights_.add(measured.height);
  recent_.push_back({observation.time, measured});
  pathAt_.push_back(pathLength_);
  hidden_.push_back(observation.hidden);
  forgetBefore(observation.time - window_);
}

double MotionEvidence::recentHidden() const {
  const double sum = std::accumulate(hidden_.begin(), hidden_.end(), 0.0);
  return hidden_.empty() ? 0.0 : sum / static_cast<double>(hidden_.size());
}

void MotionEvidence::forgetBefore(double time) {
  const auto kept = std::find_if(recent_.begin(), recent_.end(),
                                 [time](const TimedBox& timed) { return timed.time >= time; });
  const std::ptrdiff_t gone = kept - recent_.begin();
  pathAt_.erase(pathAt_.begin(), pathAt_.begin() + gone);
  hidden_.erase(hidden_.begin(), hidden_.begin() + gone);
  recent_.erase(recent_.begin(), kept);
}

}  // namespace toss
