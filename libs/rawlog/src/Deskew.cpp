// SPDX-License-Identifier: BSD-3-Clause
#include "Deskew.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace toss {
namespace {

using Transform = Eigen::Matrix<float, 3, 4>;

constexpr float kStep = 1e-3f;
/// A revolution takes at most 0.2 s: more samples are none of a sweep.
constexpr float kMaxSamples = 2000.0f;

/// Transforms from the sensor at equal steps of time to the sensor at the time stamp.
struct SampledPath {
  float begin = 0.0f, step = kStep;
  std::vector<Transform> stampFromSensor;

  Transform at(float time) const {
    const float place = (time - begin) / step;
    const auto last = static_cast<float>(stampFromSensor.size() - 2);
    const float index = std::clamp(std::floor(place), 0.0f, last);
    const auto i = static_cast<std::size_t>(index);
    const float share = place - index;
    return (1.0f - share) * stampFromSensor[i] + share * stampFromSensor[i + 1];
  }
};

/// Empty where a pose is missing.
SampledPath samplePath(const RawlogPoses& poses, const Eigen::Isometry3d* poseFromSensor,
                       PoseBuffer::Ticks stamp, const PosedScan& scan, float begin, float end) {
  const float steps = std::clamp(std::ceil((end - begin) / kStep), 1.0f, kMaxSamples);
  SampledPath path;
  path.begin = begin;
  path.step = std::max((end - begin) / steps, 1e-7f);
  const Eigen::Isometry3d stampFromMap = scan.mapFromSensor.inverse();
  for (int i = 0; i <= static_cast<int>(steps); ++i) {
    const double time = static_cast<double>(begin) + i * static_cast<double>(path.step);
    const auto found = poses.around(stamp + std::llround(time * 1e7));
    if (!found) return {};
    const Eigen::Isometry3d mapFromSensor = poseFromSensor ? *found * *poseFromSensor : *found;
    const Eigen::Isometry3d pose = stampFromMap * mapFromSensor;
    path.stampFromSensor.push_back(pose.matrix().topRows<3>().cast<float>());
  }
  return path;
}

}  // namespace

float sweepEnd(const PointCloud& points) {
  return points.time.empty() ? 0.0f : *std::max_element(points.time.begin(), points.time.end());
}

bool deskew(const RawlogPoses& poses, const Eigen::Isometry3d* poseFromSensor,
            PoseBuffer::Ticks stamp, PosedScan& scan) {
  PointCloud& points = scan.points;
  if (points.time.empty() || scan.motionCompensated) return false;
  const auto [begin, end] = std::minmax_element(points.time.begin(), points.time.end());
  const SampledPath path = samplePath(poses, poseFromSensor, stamp, scan, *begin, *end);
  if (path.stampFromSensor.empty()) return false;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector4f point(points.x[i], points.y[i], points.z[i], 1.0f);
    if (point.head<3>().isZero(0.0f)) continue;
    const Eigen::Vector3f moved = path.at(points.time[i]) * point;
    points.x[i] = moved.x(), points.y[i] = moved.y(), points.z[i] = moved.z();
  }
  scan.motionCompensated = true;
  return true;
}

}  // namespace toss
