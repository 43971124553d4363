// SPDX-License-Identifier: BSD-3-Clause
#include <toss/segmentation/LevelFrame.h>

namespace toss {

void toLevelFrame(const PointCloud& points, const Eigen::Isometry3d& mapFromSensor,
                  LevelPoints& level) {
  const std::size_t n = points.size();
  level.x.resize(n), level.y.resize(n), level.z.resize(n);
  const Eigen::Matrix3f rotation = mapFromSensor.linear().cast<float>();
  const float xx = rotation(0, 0), xy = rotation(0, 1), xz = rotation(0, 2);
  const float yx = rotation(1, 0), yy = rotation(1, 1), yz = rotation(1, 2);
  const float zx = rotation(2, 0), zy = rotation(2, 1), zz = rotation(2, 2);
  const float* const x = points.x.data();
  const float* const y = points.y.data();
  const float* const z = points.z.data();
  float* const levelX = level.x.data();
  float* const levelY = level.y.data();
  float* const levelZ = level.z.data();
  for (std::size_t i = 0; i < n; ++i) {
    // 0 for finite coordinates and NaN otherwise, infinite ones included.
    const float nanIfNotFinite = (x[i] - x[i]) + (y[i] - y[i]) + (z[i] - z[i]);
    levelX[i] = xx * x[i] + xy * y[i] + xz * z[i] + nanIfNotFinite;
    levelY[i] = yx * x[i] + yy * y[i] + yz * z[i] + nanIfNotFinite;
    levelZ[i] = zx * x[i] + zy * y[i] + zz * z[i] + nanIfNotFinite;
  }
}

}  // namespace toss
