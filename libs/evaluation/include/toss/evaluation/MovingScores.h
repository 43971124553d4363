// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

namespace toss {

/// Bands of distance from the sensor in which results are told apart: 0-20, 20-40, 40-60 m and
/// beyond (spec section 9.4).
constexpr int kRangeBands = 4;
/// Upper ends of the bands [m]; the last has none.
constexpr std::array<float, kRangeBands - 1> kRangeBandEnds = {20.0f, 40.0f, 60.0f};
/// Band 0..3 of a distance [m].
int rangeBand(float range);
/// "0-20 m" and so on.
const char* rangeBandName(int band);

/// Right and wrong among points that were called moving. Rates are NaN where undefined.
struct MovingCounts {
  /// Moving and called so; static but called moving; moving but not called so.
  std::uint64_t truePositives = 0, falsePositives = 0, falseNegatives = 0;

  void add(bool moving, bool calledMoving);
  /// IoU = TP / (TP + FP + FN), 0 to 1.
  double intersectionOverUnion() const;
  double precision() const;
  double recall() const;
};

/// Points of one true class, and of them those that were called moving.
struct ClassCounts {
  std::uint64_t points = 0, calledMoving = 0;
};

/// Moving objects that were seen in single scans, and of them those of whose returns at least half
/// were called moving.
struct ObjectCounts {
  std::uint64_t objects = 0, found = 0;
};

/// Moving-object segmentation scored as semantic-kitti-mos does (spec section 9.4): true classes 0
/// and 1 are ignored, 251 to 259 are moving, all others static. What is called moving is 251 to
/// 259; 0 and everything else is not.
struct MovingScores {
  MovingCounts all;
  std::array<MovingCounts, kRangeBands> byRange;
  /// By true class, ascending.
  std::map<std::uint32_t, ClassCounts> byClass;
  /// Objects told apart by true class and instance number, by the band of their mean distance.
  std::array<ObjectCounts, kRangeBands> objectsByRange;

  /// Adds one scan: true labels, called labels and distances from the sensor [m], shape [n] each.
  void addScan(const std::vector<std::uint32_t>& truth, const std::vector<std::uint32_t>& called,
               const std::vector<float>& range);

 private:
  void addObjects(const std::vector<std::uint32_t>& truth, const std::vector<std::uint32_t>& called,
                  const std::vector<float>& range);
};

}  // namespace toss
