// SPDX-License-Identifier: BSD-3-Clause
#include "PcdFrameCheck.h"

#include <algorithm>

namespace toss {
namespace {

/// Nearer to the origin the two look alike [m].
constexpr double kFarFromOrigin = 20.0;
constexpr std::size_t kSample = 500;

double medianDistance(const PcdScan& pcd, const Eigen::Vector3d& from) {
  std::vector<double> distances;
  const std::size_t step = std::max<std::size_t>(1, pcd.points.size() / kSample);
  for (std::size_t i = 0; i < pcd.points.size(); i += step) {
    const MapPoint& p = pcd.points[i];
    distances.push_back((pcd.offset + Eigen::Vector3d(p.x, p.y, p.z) - from).norm());
  }
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return *middle;
}

}  // namespace

void PcdFrameCheck::add(const PcdScan& pcd, const Eigen::Isometry3d& pose) {
  ++scans_;
  if (!firstPose_) firstPose_ = pose;
  posesDiffer_ |= pose.matrix() != firstPose_->matrix();
  if (pcd.points.empty() || pose.translation().norm() < kFarFromOrigin) return;
  const bool nearSensor =
      medianDistance(pcd, pose.translation()) < medianDistance(pcd, Eigen::Vector3d::Zero());
  ++(nearSensor ? aroundSensor_ : aroundOrigin_);
}

void PcdFrameCheck::appendWarnings(const PcdImportOptions& options,
                                   std::vector<std::string>& warnings) const {
  if (scans_ > 1 && !posesDiffer_)
    warnings.emplace_back(
        "all scans have the same pose: either the sensor stood still, or the line VIEWPOINT was "
        "never set; give the poses with --poses");
  const bool inMap = options.frame == PcdImportOptions::Frame::Map;
  if (inMap && aroundOrigin_ > aroundSensor_)
    warnings.emplace_back(
        "the points lie around the origin and not around the sensor: they seem to be in the sensor "
        "frame; try --frame sensor");
  if (!inMap && aroundSensor_ > aroundOrigin_)
    warnings.emplace_back(
        "the points lie around the sensor's pose and not around the origin: they seem to be in the "
        "map frame; try --frame map");
}

}  // namespace toss
