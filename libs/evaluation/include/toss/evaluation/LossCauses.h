// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/evaluation/MovingScores.h>
#include <toss/evaluation/PreservationRejection.h>

#include <array>
#include <cstdint>
#include <vector>

namespace toss {

/// Why a moving return can not, or did not, leave the map (spec section 11.1).
enum class LossCause : std::uint8_t {
  Classification,   ///< in an instance that is mostly moving: tracking or voting called it static
  Ground,           ///< segmentation called it ground, or below it
  Merged,           ///< in an instance that is mostly static
  NoInstance,       ///< in no instance, though its object has 10 returns or more in the scan
  NoInstanceSmall,  ///< in no instance, and its object has fewer than 10 returns in the scan
  Invalid           ///< out of range, or not valid to the run
};
constexpr int kLossCauses = 6;
/// Name as in reports.
const char* lossCauseName(LossCause cause);

/// Returns of the object in the scan, in steps: under 3, 3-4, 5-9, 10-49, 50 and more.
constexpr int kReturnSteps = 5;
int returnStep(std::uint64_t returns);
const char* returnStepName(int step);

/// What is carried along with a return in the high 16 bits of its label, through all voxels.
struct ReturnFacts {
  /// Band of the distance from the sensor, see rangeBand().
  int band = 0;
  /// Step of the number of returns of its object, see returnStep().
  int returns = 0;
  LossCause cause = LossCause::Classification;
};

/// Class (low 16 bits) and facts in one label, and back.
std::uint32_t packFacts(std::uint32_t trueClass, const ReturnFacts& facts);
ReturnFacts unpackFacts(std::uint32_t label);

/// Voxels of one kind, and of them those with the right fate.
struct VoxelCounts {
  std::uint64_t voxels = 0, right = 0;
};

/// Where a map loses static voxels and keeps moving ones.
struct LossTable {
  /// Residue voxels by the cause of the return that the estimate has there.
  std::array<std::uint64_t, kLossCauses> residueByCause{};
  /// Moving voxels, and of them those removed, by distance and by the object's returns.
  std::array<VoxelCounts, kRangeBands> movingByRange{};
  std::array<VoxelCounts, kReturnSteps> movingByReturns{};
  /// Static voxels, and of them those kept, by distance.
  std::array<VoxelCounts, kRangeBands> staticByRange{};
};

/// The losses of one comparison of maps whose labels were packed by packFacts().
LossTable lossTable(const LabelledCloud& truth, const LabelledCloud& estimate,
                    const MapComparison& comparison);

}  // namespace toss
