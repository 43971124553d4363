// SPDX-License-Identifier: BSD-3-Clause
#include "ClaimFootprint.h"

#include <algorithm>

namespace toss {
namespace {

using Span = ClaimFootprint::Span;

/// Cuts `span` to the y for which factor * y lies in an interval, measured from `origin`.
void cut(Span& span, float origin, float factor, float low, float high) {
  // Sides along y bound nothing.
  if (std::fabs(factor) < 1e-6f) return;
  const float a = origin + low / factor, b = origin + high / factor;
  span.low = std::max(span.low, std::min(a, b));
  span.high = std::min(span.high, std::max(a, b));
}

}  // namespace

ClaimFootprint::ClaimFootprint(const Box& box, const Eigen::Vector3d& sensorPosition,
                               double below) {
  const Eigen::Vector3f center = (box.center - sensorPosition).cast<float>();
  x = center.x(), y = center.y();
  cosYaw = static_cast<float>(std::cos(box.yaw)), sinYaw = static_cast<float>(std::sin(box.yaw));
  halfLength = static_cast<float>(0.5 * box.length);
  halfWidth = static_cast<float>(0.5 * box.width);
  low = center.z() - static_cast<float>(0.5 * box.height + below);
  high = center.z() + static_cast<float>(0.5 * box.height);
}

Eigen::AlignedBox2f ClaimFootprint::extent(float margin) const {
  const float length = halfLength + margin, width = halfWidth + margin;
  const Eigen::Vector2f reach(length * std::fabs(cosYaw) + width * std::fabs(sinYaw),
                              length * std::fabs(sinYaw) + width * std::fabs(cosYaw));
  const Eigen::Vector2f middle(x, y);
  return {middle - reach, middle + reach};
}

Span ClaimFootprint::between(float firstX, float lastX, float margin) const {
  const float length = halfLength + margin, width = halfWidth + margin;
  const float c0 = cosYaw * (firstX - x), c1 = cosYaw * (lastX - x);
  const float s0 = sinYaw * (firstX - x), s1 = sinYaw * (lastX - x);
  const Eigen::AlignedBox2f around = extent(margin);
  Span span{around.min().y(), around.max().y()};
  cut(span, y, sinYaw, -length - std::max(c0, c1), length - std::min(c0, c1));
  cut(span, y, cosYaw, -width + std::min(s0, s1), width + std::max(s0, s1));
  return span;
}

}  // namespace toss
