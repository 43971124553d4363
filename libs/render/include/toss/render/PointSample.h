// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/mapping/VoxelMap.h>

#include <cstdint>
#include <vector>

namespace toss {

/// Keeps at most `limit` of the points that pass by: each with the same chance, chosen by its
/// number alone, so the same points give the same sample. Constant memory.
class PointSample {
 public:
  /// `limit`: at least 1.
  explicit PointSample(std::size_t limit);

  void add(const MapPoint& point);
  /// What was kept, in the order in which it came.
  const std::vector<MapPoint>& points() const { return points_; }
  /// The same, which is not kept any longer: the next point is the first of another sample.
  std::vector<MapPoint> take();
  /// Points that came by.
  std::uint64_t seen() const { return seen_; }

 private:
  bool passes(std::uint64_t number) const;
  void thin();

  std::size_t limit_;
  std::vector<MapPoint> points_;
  std::vector<std::uint64_t> numbers_;
  std::uint64_t seen_ = 0;
  int halvings_ = 0;
};

/// Indices of such a sample of n points, ascending; all of them where n is within the limit.
std::vector<std::uint32_t> sampleIndices(std::size_t n, std::size_t limit);

}  // namespace toss
