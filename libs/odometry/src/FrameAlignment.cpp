// SPDX-License-Identifier: BSD-3-Clause
#include "FrameAlignment.h"

#include <Eigen/Cholesky>
#include <Eigen/SVD>

namespace toss {
namespace {

constexpr double kArm = 10.0;

Eigen::Vector3d rotationVector(const Eigen::Isometry3d& motion) {
  const Eigen::AngleAxisd rotation(motion.linear());
  return rotation.angle() * rotation.axis();
}

/// The rotation that turns the axes of found motions into those of the given ones (Kabsch); what
/// the motions leave open stays as it is.
Eigen::Matrix3d axesOf(const std::vector<MotionPair>& pairs) {
  Eigen::Matrix3d correlation = Eigen::Matrix3d::Zero();
  for (const MotionPair& pair : pairs) {
    correlation += pair.given.translation() * pair.found.translation().transpose();
    correlation +=
        kArm * kArm * rotationVector(pair.given) * rotationVector(pair.found).transpose();
  }
  correlation += 1e-3 * correlation.norm() * Eigen::Matrix3d::Identity();
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(correlation,
                                              Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Vector3d signs = Eigen::Vector3d::Ones();
  signs.z() = (svd.matrixU() * svd.matrixV().transpose()).determinant();
  return svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
}

}  // namespace

double reach(const Eigen::Isometry3d& motion) {
  return motion.translation().norm() + kArm * Eigen::AngleAxisd(motion.linear()).angle();
}

Eigen::Isometry3d cameraAxesFromLidar() {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() << 0, -1, 0, 0, 0, -1, 1, 0, 0;
  return pose;
}

Eigen::Isometry3d poseFrameFromSensor(const std::vector<MotionPair>& pairs) {
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  frame.linear() = axesOf(pairs);
  // given X = X found: (R_given - 1) t = R_X t_found - t_given.
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  Eigen::Vector3d vector = Eigen::Vector3d::Zero();
  for (const MotionPair& pair : pairs) {
    const Eigen::Matrix3d turn = pair.given.linear() - Eigen::Matrix3d::Identity();
    matrix += turn.transpose() * turn;
    vector +=
        turn.transpose() * (frame.linear() * pair.found.translation() - pair.given.translation());
  }
  // Turns of less than 0.01 rad tell nothing; nor does any turn along its own axis.
  matrix += 1e-4 * static_cast<double>(pairs.size()) * Eigen::Matrix3d::Identity();
  frame.translation() = matrix.ldlt().solve(vector);
  return frame;
}

}  // namespace toss
