// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/Options.h>

namespace toss {

/// What becomes of returns that are too near or too far to be segmented (spec section 1.1).
enum class FarPoints { KeepStatic, Drop };

/// Options of the static map, section [map] (spec section 8).
struct MappingOptions : Options {
  /// Edge of a voxel [m]; 0 = no voxels, every kept return is a point of the map.
  double voxelSize = 0.1;
  /// Returns that one scan and instance may add to one voxel; limits the weight of what is seen
  /// for a long time. No effect without voxels.
  int cap = 50;
  /// Returns a voxel needs to be a point of the finished map. No effect without voxels.
  int minPoints = 1;
  /// Whether returns clearly below the ground (mirrors, multi-path) go into the map.
  bool keepBelowGround = false;
  /// What becomes of returns out of range.
  FarPoints farPoints = FarPoints::KeepStatic;
  /// Time between a scan and the entry of its boxes into the map [s]; revocation makes the final
  /// map independent of it.
  double insertionDelay = 0.5;
  /// Least edge of the cubes of the map that are put on disk while they are far from the robot [m],
  /// made larger to be 2^k times 16 voxels; 0 = the map stays in memory. Does not change the map.
  double tileSize = 100.0;
  /// Cubes that are nearer to the robot stay in memory [m].
  double tilesKeepRadius = 300.0;

  const char* section() const override { return "map"; }
  void visit(OptionVisitor& visitor) override;
};

}  // namespace toss
