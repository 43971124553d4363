// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/evaluation/CellOrder.h>

#include <cstdint>
#include <vector>

namespace toss {

/// Static and dynamic accuracy in points (DynamicMap_Benchmark; spec section 9.4), in percent; NaN
/// where there is nothing to count.
struct RemovalAccuracy {
  /// Static points, and of them those that are kept.
  std::uint64_t staticPoints = 0, staticKept = 0;
  /// Moving points, and of them those that are removed.
  std::uint64_t movingPoints = 0, movingRemoved = 0;

  /// Counts one point of the truth. A point is kept where the nearest point of the output is no
  /// farther than the removal distance.
  void add(bool moving, bool kept);
  double staticAccuracy() const;
  double dynamicAccuracy() const;
  /// AA = sqrt(SA DA).
  double associatedAccuracy() const;
  /// HA = 2 SA DA / (SA + DA).
  double harmonicAccuracy() const;
};

/// RemovalAccuracy of labels: the output is the points that were kept, without voxels. A point that
/// is kept is at distance 0 from it; the others are held against the points kept in all scans. Two
/// passes over the scans, so that only what was removed is held in memory.
class LabelRemovalAccuracy {
 public:
  /// `removalDistance` [m], at most `cellSize`, the size of the cells by which scans are ordered
  /// [m].
  LabelRemovalAccuracy(double removalDistance, double cellSize);

  /// First pass: one point of the truth that counts.
  void add(float x, float y, float z, bool moving, bool kept);
  /// Between the passes.
  void endFirstPass();
  /// Second pass: the points that were kept in one scan.
  void addKept(const CellOrder& kept);
  /// After the second pass.
  RemovalAccuracy result() const;

 private:
  double removalDistance_, cellSize_;
  RemovalAccuracy kept_;
  LabelledCloud removed_;
  CellOrder removedOrder_;
  /// Whether a point that was kept lies within the removal distance, by place in removedOrder_.
  std::vector<char> near_;
};

}  // namespace toss
