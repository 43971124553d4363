// SPDX-License-Identifier: BSD-3-Clause
#include "ClaimFootprint.h"

namespace toss {
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

}  // namespace toss
