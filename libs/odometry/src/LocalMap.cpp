// SPDX-License-Identifier: BSD-3-Clause
#include <tbb/parallel_for.h>
#include <toss/odometry/Downsampling.h>
#include <toss/odometry/LocalMap.h>
#include <tsl/robin_map.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "KeyHash.h"

namespace toss {
namespace {

constexpr std::size_t kMostPoints = 20;

/// Points of one voxel, relative to its corner: floats stay exact far from the origin.
struct Voxel {
  std::array<Eigen::Vector3f, kMostPoints> points;
  std::uint32_t count = 0;
  Surface surface = Surface::Unknown;
  Eigen::Vector3f normal;
};

/// Sums of the points around a voxel.
struct Moments {
  Eigen::Matrix3f squares = Eigen::Matrix3f::Zero();
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  int count = 0;

  void add(const Eigen::Vector3f& point) {
    squares += point * point.transpose();
    sum += point;
    ++count;
  }
  Eigen::Matrix3f covariance() const {
    const Eigen::Vector3f mean = sum / static_cast<float>(count);
    return squares / static_cast<float>(count) - mean * mean.transpose();
  }
};

}  // namespace

struct LocalMap::Implementation {
  double size;
  std::size_t most;
  float spacingSquared;
  /// Number of the voxel in `voxels`.
  tsl::robin_map<VoxelKey, std::uint32_t, KeyHash> index;
  std::vector<Voxel> voxels;
  /// Numbers of voxels that were forgotten, for use by new ones.
  std::vector<std::uint32_t> unused;
  std::size_t points = 0;

  Eigen::Vector3d cornerOf(VoxelKey key) const {
    const auto [x, y, z] = voxelIndex(key);
    return size * Eigen::Vector3d(x, y, z);
  }

  Voxel& at(VoxelKey key) {
    const auto next = static_cast<std::uint32_t>(unused.empty() ? voxels.size() : unused.back());
    const auto [found, isNew] = index.try_emplace(key, next);
    if (!isNew) return voxels[found->second];
    if (unused.empty())
      voxels.emplace_back();
    else
      unused.pop_back();
    return voxels[next];
  }

  /// Whether the point was taken: then the surface around it has to be looked at again.
  bool add(const Eigen::Vector3d& point) {
    const VoxelKey key = voxelOf(point, size);
    Voxel& voxel = at(key);
    if (voxel.count >= most) return false;
    const Eigen::Vector3f offset = (point - cornerOf(key)).cast<float>();
    for (std::uint32_t i = 0; i < voxel.count; ++i)
      if ((voxel.points[i] - offset).squaredNorm() < spacingSquared) return false;
    voxel.points[voxel.count++] = offset;
    ++points;
    return true;
  }

  /// Calls `use` with the key and the voxel of each of the 27 voxels around `center` that exist.
  template <typename Use>
  void forEachAround(const Eigen::Array3i& center, Use use) const {
    for (int dx = -1; dx <= 1; ++dx)
      for (int dy = -1; dy <= 1; ++dy)
        for (int dz = -1; dz <= 1; ++dz) {
          const Eigen::Array3i at = center + Eigen::Array3i(dx, dy, dz);
          const auto found = index.find(voxelKey(at.x(), at.y(), at.z()));
          if (found != index.end()) use(at, voxels[found->second]);
        }
  }

  void lookAtSurface(VoxelKey key, const Eigen::Vector3f& up);
};

void LocalMap::Implementation::lookAtSurface(VoxelKey key, const Eigen::Vector3f& up) {
  constexpr int kFewest = 8;
  constexpr float kPlanarity = 0.1f, kLinearity = 0.1f, kRing = 0.5f;
  Voxel& voxel = voxels[index.at(key)];
  Eigen::Vector3f mean = Eigen::Vector3f::Zero();
  for (std::uint32_t i = 0; i < voxel.count; ++i) mean += voxel.points[i];
  mean /= static_cast<float>(voxel.count);
  const auto [x, y, z] = voxelIndex(key);
  const Eigen::Array3i center(x, y, z);
  const float edge = static_cast<float>(size);
  Moments moments;
  forEachAround(center, [&](const Eigen::Array3i& at, const Voxel& near) {
    const Eigen::Vector3f shift = edge * (at - center).cast<float>().matrix() - mean;
    for (std::uint32_t i = 0; i < near.count; ++i)
      if ((near.points[i] + shift).squaredNorm() < edge * edge) moments.add(near.points[i] + shift);
  });
  voxel.surface = Surface::Unknown;
  if (moments.count < kFewest) return;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> axes;
  axes.computeDirect(moments.covariance());
  const Eigen::Vector3f spread = axes.eigenvalues().cwiseMax(0.0f);
  const bool line = spread.y() < kLinearity * spread.z();
  if (line && std::abs(axes.eigenvectors().col(2).dot(up)) < kRing) return;
  voxel.surface =
      spread.x() < kPlanarity * spread.y() && !line ? Surface::Plane : Surface::Scattered;
  voxel.normal = axes.eigenvectors().col(0);
}

LocalMap::LocalMap(double voxelSize, int pointsPerVoxel)
    : implementation_(std::make_unique<Implementation>()) {
  implementation_->size = voxelSize;
  implementation_->most = std::min(static_cast<std::size_t>(pointsPerVoxel), kMostPoints);
  implementation_->spacingSquared = static_cast<float>(voxelSize * voxelSize / pointsPerVoxel);
}

LocalMap::~LocalMap() = default;
LocalMap::LocalMap(LocalMap&&) noexcept = default;

void LocalMap::add(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& up) {
  std::vector<VoxelKey> changed;
  for (const Eigen::Vector3d& point : points)
    if (implementation_->add(point)) changed.push_back(voxelOf(point, implementation_->size));
  std::sort(changed.begin(), changed.end());
  changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
  const Eigen::Vector3f axis = up.cast<float>();
  tbb::parallel_for(std::size_t{0}, changed.size(),
                    [&](std::size_t i) { implementation_->lookAtSurface(changed[i], axis); });
}

void LocalMap::forgetBeyond(const Eigen::Vector3d& center, double range) {
  Implementation& map = *implementation_;
  std::vector<VoxelKey> far;
  for (const auto& [key, number] : map.index)
    if ((map.cornerOf(key) - center).squaredNorm() > range * range) far.push_back(key);
  // The order of the hash table depends on its history: what is reused next must not.
  std::sort(far.begin(), far.end());
  for (const VoxelKey key : far) {
    const std::uint32_t number = map.index.at(key);
    map.points -= map.voxels[number].count;
    map.voxels[number].count = 0;
    map.unused.push_back(number);
    map.index.erase(key);
  }
}

Neighbor LocalMap::nearest(const Eigen::Vector3d& point) const {
  const Implementation& map = *implementation_;
  const Eigen::Array3i center = (point.array() / map.size).floor().cast<int>();
  const Eigen::Vector3d corner = map.size * center.cast<double>().matrix();
  const Eigen::Vector3f offset = (point - corner).cast<float>();
  const float edge = static_cast<float>(map.size);
  float best = std::numeric_limits<float>::infinity();
  Neighbor result;
  map.forEachAround(center, [&](const Eigen::Array3i& at, const Voxel& voxel) {
    const Eigen::Vector3f shift = edge * (at - center).cast<float>().matrix();
    for (std::uint32_t i = 0; i < voxel.count; ++i) {
      const float distance = (voxel.points[i] + shift - offset).squaredNorm();
      if (distance >= best) continue;
      best = distance;
      result.point = corner + (voxel.points[i] + shift).cast<double>();
      result.surface = voxel.surface;
      result.normal = voxel.normal;
    }
  });
  result.squaredDistance = best;
  return result;
}

bool LocalMap::empty() const {
  return implementation_->index.empty();
}

std::size_t LocalMap::size() const {
  return implementation_->points;
}

}  // namespace toss
