// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/poses/CPose3D.h>
#include <toss/rawlog/MrptConversion.h>

#include <cmath>

namespace toss {
namespace {

using Ticks = mrpt::Clock::rep;
constexpr Ticks kTicksPerSecond = 10'000'000;
/// MRPT counts from the year 1601.
constexpr Ticks kUnixEpoch = 11'644'473'600 * kTicksPerSecond;

}  // namespace

mrpt::poses::CPose3D toMrpt(const Eigen::Isometry3d& pose) {
  const Eigen::Matrix4d matrix = pose.matrix();
  return mrpt::poses::CPose3D(mrpt::math::CMatrixDouble44(matrix));
}

Eigen::Isometry3d fromMrpt(const mrpt::poses::CPose3D& pose) {
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.linear() = pose.getRotationMatrix().asEigen();
  result.translation() << pose.x(), pose.y(), pose.z();
  return result;
}

mrpt::Clock::time_point toMrptTime(double seconds) {
  // Whole seconds and the rest apart: their product with 1e7 would not fit a double's mantissa.
  const double whole = std::floor(seconds);
  const Ticks ticks = static_cast<Ticks>(whole) * kTicksPerSecond +
                      static_cast<Ticks>(std::llround((seconds - whole) * kTicksPerSecond));
  return mrpt::Clock::time_point(mrpt::Clock::duration(ticks + kUnixEpoch));
}

double fromMrptTime(mrpt::Clock::time_point time) {
  const Ticks ticks = time.time_since_epoch().count() - kUnixEpoch;
  return static_cast<double>(ticks / kTicksPerSecond) +
         static_cast<double>(ticks % kTicksPerSecond) / static_cast<double>(kTicksPerSecond);
}

bool isRigid(const Eigen::Isometry3d& pose) {
  const Eigen::Matrix3d deviation =
      pose.linear() * pose.linear().transpose() - Eigen::Matrix3d::Identity();
  return pose.matrix().allFinite() && deviation.cwiseAbs().maxCoeff() < 1e-3 &&
         pose.linear().determinant() > 0.0;
}

}  // namespace toss
