// SPDX-License-Identifier: BSD-3-Clause
#include <toss/geometry/ProcessorVariants.h>
#include <toss/segmentation/LevelFrame.h>

namespace toss {
namespace {

/// One coordinate of the level frame. The compiler vectorises it as a function of arrays that are
/// known not to overlap.
TOSS_ALSO_FOR_AVX2
void combine(const Eigen::Vector3f& row, const float* __restrict x, const float* __restrict y,
             const float* __restrict z, std::size_t n, float* __restrict level) {
  const float a = row.x(), b = row.y(), c = row.z();
  for (std::size_t i = 0; i < n; ++i) {
    // 0 for finite coordinates and NaN otherwise, infinite ones included.
    const float nanIfNotFinite = (x[i] - x[i]) + (y[i] - y[i]) + (z[i] - z[i]);
    level[i] = a * x[i] + b * y[i] + c * z[i] + nanIfNotFinite;
  }
}

}  // namespace

void toLevelFrame(const PointCloud& points, const Eigen::Isometry3d& mapFromSensor,
                  LevelPoints& level) {
  const std::size_t n = points.size();
  level.x.resize(n), level.y.resize(n), level.z.resize(n);
  const Eigen::Matrix3f rotation = mapFromSensor.linear().cast<float>();
  float* const coordinates[3] = {level.x.data(), level.y.data(), level.z.data()};
  for (int axis = 0; axis < 3; ++axis) {
    combine(rotation.row(axis), points.x.data(), points.y.data(), points.z.data(), n,
            coordinates[axis]);
  }
}

}  // namespace toss
