// SPDX-License-Identifier: BSD-3-Clause
#include <tbb/parallel_for.h>
#include <toss/odometry/Registration.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>

namespace toss {
namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

/// Points summed by one task: fixed, so that sums do not depend on the number of threads.
constexpr std::size_t kChunk = 128;

/// Weight of a pair of points as against one of a point and a plane: points of the map keep a
/// distance from each other, so that their residuals are some three times as large.
constexpr double kScatteredWeight = 0.1;

/// Scale of Alignment::fit [m^2].
constexpr double kFitScale = 0.01;

/// The normal equations of one Gauss-Newton step; unknowns: translation, rotation vector about the
/// sensor (near it the rotation is well conditioned wherever the map's origin is).
struct NormalEquations {
  Matrix6 matrix = Matrix6::Zero();
  Vector6 vector = Vector6::Zero();
  std::size_t pairs = 0, paired = 0;
  double fitness = 0.0, fit = 0.0;

  void add(const Eigen::Vector3d& arm, const Eigen::Vector3d& residual, double weight) {
    Eigen::Matrix<double, 3, 6> jacobian;
    jacobian.leftCols<3>().setIdentity();
    jacobian.rightCols<3>() << 0.0, arm.z(), -arm.y(), -arm.z(), 0.0, arm.x(), arm.y(), -arm.x(),
        0.0;
    matrix.noalias() += weight * jacobian.transpose() * jacobian;
    vector.noalias() += weight * jacobian.transpose() * residual;
    ++pairs;
  }
  void add(const Eigen::Vector3d& arm, const Eigen::Vector3d& normal, double distance,
           double weight) {
    Vector6 jacobian;
    jacobian << normal, arm.cross(normal);
    matrix.noalias() += weight * jacobian * jacobian.transpose();
    vector += weight * distance * jacobian;
    ++pairs;
  }
  void add(const NormalEquations& other) {
    paired += other.paired;
    fitness += other.fitness;
    fit += other.fit;
    matrix += other.matrix;
    vector += other.vector;
    pairs += other.pairs;
  }
};

NormalEquations equationsOf(const std::vector<Eigen::Vector3d>& points, std::size_t begin,
                            std::size_t end, const LocalMap& map, const Eigen::Isometry3d& pose,
                            const RegistrationLimits& limits) {
  NormalEquations sum;
  const double scale = limits.kernelScale;
  for (std::size_t i = begin; i < end; ++i) {
    const Eigen::Vector3d arm = pose.linear() * points[i];
    const Eigen::Vector3d point = arm + pose.translation();
    const Neighbor nearest = map.nearest(point);
    if (nearest.squaredDistance > limits.maxDistance * limits.maxDistance) continue;
    ++sum.paired;
    if (nearest.surface == Surface::Unknown) continue;
    const Eigen::Vector3d residual = point - nearest.point;
    const Eigen::Vector3d normal = nearest.normal.cast<double>();
    const bool plane = nearest.surface == Surface::Plane;
    const double distance = normal.dot(residual);
    const double squared = plane ? distance * distance : nearest.squaredDistance;
    const double root = scale / (scale + squared);
    sum.fitness += root;
    sum.fit += kFitScale / (kFitScale + squared);
    if (plane)
      sum.add(arm, normal, distance, root * root);
    else
      sum.add(arm, residual, kScatteredWeight * root * root);
  }
  return sum;
}

NormalEquations equationsOf(const std::vector<Eigen::Vector3d>& points, const LocalMap& map,
                            const Eigen::Isometry3d& pose, const RegistrationLimits& limits) {
  std::vector<NormalEquations> parts((points.size() + kChunk - 1) / kChunk);
  tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t part) {
    const std::size_t begin = part * kChunk, end = std::min(begin + kChunk, points.size());
    parts[part] = equationsOf(points, begin, end, map, pose, limits);
  });
  NormalEquations sum;
  for (const NormalEquations& part : parts) sum.add(part);
  return sum;
}

Eigen::Quaterniond rotationOf(const Eigen::Vector3d& vector) {
  const double angle = vector.norm();
  if (angle < 1e-15) return Eigen::Quaterniond::Identity();
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle, vector / angle));
}

/// Smallest eigenvalue of the part for the translation, as a share of their sum.
double weakestHold(const Matrix6& matrix) {
  const Eigen::Matrix3d translation = matrix.topLeftCorner<3, 3>();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(translation, Eigen::EigenvaluesOnly);
  const double sum = translation.trace();
  return sum > 0.0 ? std::max(0.0, axes.eigenvalues()[0]) / sum : 0.0;
}

}  // namespace

double fitness(const std::vector<Eigen::Vector3d>& points, const LocalMap& map,
               const Eigen::Isometry3d& pose, const RegistrationLimits& limits) {
  if (points.empty()) return 0.0;
  return equationsOf(points, map, pose, limits).fitness / static_cast<double>(points.size());
}

Alignment align(const std::vector<Eigen::Vector3d>& points, const LocalMap& map,
                const Eigen::Isometry3d& guess, const RegistrationLimits& limits) {
  constexpr std::size_t kFewestPairs = 6;
  Alignment result;
  result.mapFromSensor = guess;
  Eigen::Quaterniond rotation(guess.linear());
  while (result.iterations < limits.maxIterations && !result.converged) {
    const NormalEquations sum = equationsOf(points, map, result.mapFromSensor, limits);
    result.overlap =
        points.empty() ? 0.0 : static_cast<double>(sum.paired) / static_cast<double>(points.size());
    result.fit = points.empty() ? 0.0 : sum.fit / static_cast<double>(points.size());
    result.weakestHold = weakestHold(sum.matrix);
    if (sum.pairs < kFewestPairs) return result;
    const Vector6 step = -sum.matrix.ldlt().solve(sum.vector);
    if (!step.allFinite()) return result;
    rotation = (rotationOf(step.tail<3>()) * rotation).normalized();
    result.mapFromSensor.linear() = rotation.toRotationMatrix();
    result.mapFromSensor.translation() += step.head<3>();
    ++result.iterations;
    result.converged = step.norm() < limits.convergence;
  }
  return result;
}

}  // namespace toss
