// SPDX-License-Identifier: BSD-3-Clause
#include "PoseBuffer.h"

#include <algorithm>
#include <iterator>

namespace toss {

Eigen::Isometry3d interpolate(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b,
                              double share) {
  const Eigen::Quaterniond from(a.linear()), to(b.linear());
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.linear() = from.normalized().slerp(share, to.normalized()).toRotationMatrix();
  result.translation() = (1.0 - share) * a.translation() + share * b.translation();
  return result;
}

void PoseBuffer::add(Ticks time, const Eigen::Isometry3d& pose) {
  poses_.emplace(time, pose);
}

std::optional<Eigen::Isometry3d> PoseBuffer::at(Ticks time) const {
  const auto after = poses_.lower_bound(time);
  if (after == poses_.end()) return std::nullopt;
  if (after->first == time) return after->second;
  if (after == poses_.begin()) return std::nullopt;
  const auto before = std::prev(after);
  if (after->first - time > maxGap_ || time - before->first > maxGap_) return std::nullopt;
  const double share =
      static_cast<double>(time - before->first) / static_cast<double>(after->first - before->first);
  return interpolate(before->second, after->second, share);
}

std::optional<Eigen::Isometry3d> PoseBuffer::around(Ticks time) const {
  if (poses_.size() < 2) return std::nullopt;
  auto b = poses_.upper_bound(time);
  if (b == poses_.begin()) ++b;
  if (b == poses_.end()) --b;
  const auto a = std::prev(b);
  const Ticks beyond = std::max(a->first - time, time - b->first);
  if (std::max(beyond, b->first - a->first) > 2 * maxGap_) return std::nullopt;
  const double share =
      static_cast<double>(time - a->first) / static_cast<double>(b->first - a->first);
  return interpolate(a->second, b->second, share);
}

bool PoseBuffer::mayStillCome(Ticks time) const {
  return poses_.empty() || poses_.rbegin()->first < time + maxGap_;
}

void PoseBuffer::forgetBefore(Ticks time) {
  auto first = poses_.lower_bound(time - maxGap_);
  // The last one before stays, to tell that poses are there but too far away.
  if (first != poses_.begin()) --first;
  poses_.erase(poses_.begin(), first);
}

}  // namespace toss
