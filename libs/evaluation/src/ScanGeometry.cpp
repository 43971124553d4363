// SPDX-License-Identifier: BSD-3-Clause
#include "ScanGeometry.h"

#include <cmath>
#include <limits>

namespace toss {
namespace {

void resize(std::size_t n, ScanGeometry& result) {
  result.cloud.x.resize(n), result.cloud.y.resize(n), result.cloud.z.resize(n);
  result.cloud.label.assign(n, 0);
  result.range.resize(n), result.horizontalRange.resize(n);
}

}  // namespace

Eigen::Vector3d evaluationOrigin(const Eigen::Vector3d& sensor, double voxelSize) {
  const double step = 1000.0 * voxelSize;
  return (sensor / step).array().round().matrix() * step;
}

void transformScan(const PosedScan& scan, const Eigen::Vector3d& origin, ScanGeometry& result) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  const Eigen::Matrix3d rotation = scan.mapFromSensor.linear();
  const Eigen::Vector3d translation = scan.mapFromSensor.translation() - origin;
  const PointCloud& points = scan.points;
  resize(points.size(), result);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d p(points.x[i], points.y[i], points.z[i]);
    const double range = p.norm();
    const bool valid = std::isfinite(range) && range > 0.0;
    const Eigen::Vector3d q = rotation * p + translation;
    result.cloud.x[i] = valid ? static_cast<float>(q.x()) : nan;
    result.cloud.y[i] = valid ? static_cast<float>(q.y()) : nan;
    result.cloud.z[i] = valid ? static_cast<float>(q.z()) : nan;
    result.range[i] = valid ? static_cast<float>(range) : 0.0f;
    result.horizontalRange[i] = valid ? static_cast<float>(p.head<2>().norm()) : 0.0f;
  }
}

}  // namespace toss
