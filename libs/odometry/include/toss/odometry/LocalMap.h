// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

namespace toss {

/// What the surface around a point of the map is like.
enum class Surface : std::uint8_t {
  Scattered,  ///< no surface: foliage, edges, poles; holds a pose in every direction
  Plane,      ///< holds a pose along its normal only
  Unknown     ///< too few points, or a line such as one beam draws on any surface
};

/// The point of the map next to another one.
struct Neighbor {
  /// Map frame [m].
  Eigen::Vector3d point;
  /// Distance [m] squared; infinity where there is none, and all else is undefined then.
  double squaredDistance = 0.0;
  Surface surface = Surface::Unknown;
  /// Unit normal, map frame; of planes only.
  Eigen::Vector3f normal;
};

/// The surroundings as the last scans have seen them: points in voxels, found by hashing (KISS-ICP,
/// section III-D).
class LocalMap {
 public:
  /// `voxelSize` [m]: edge of the voxels, and the farthest that a neighbour is found for certain.
  /// `pointsPerVoxel`: at most 20; points keep a distance of voxelSize / sqrt(pointsPerVoxel).
  LocalMap(double voxelSize, int pointsPerVoxel);
  ~LocalMap();
  LocalMap(LocalMap&&) noexcept;

  /// Adds points [m, map frame] to voxels that have room for them, in their order. `up`: the axis
  /// that the sensor spins about, map frame: beams draw lines that are square to it.
  void add(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& up);
  /// Forgets the voxels farther than `range` [m] from `center` [m, map frame].
  void forgetBeyond(const Eigen::Vector3d& center, double range);
  /// The point next to `point` [m, map frame] in its voxel and the 26 around it. Safe to call from
  /// several threads.
  Neighbor nearest(const Eigen::Vector3d& point) const;

  bool empty() const;
  /// Points held.
  std::size_t size() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace toss
