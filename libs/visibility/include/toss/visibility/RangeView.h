// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/PointCloud.h>
#include <toss/segmentation/RangeImage.h>
#include <toss/visibility/VisibilityOptions.h>

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

namespace toss {

/// The ranges that one scan measured, kept to be asked later: "did you see through this point?"
class RangeView {
 public:
  /// `points`: the scan behind `image`, sensor frame; `mapFromSensor`: pose of the sensor then.
  /// Returns are filed by their elevation, not by the beam that made them: points are looked up by
  /// elevation, and on a robot that pitches within its sweep the two differ by several rows.
  RangeView(const RangeImage& image, const PointCloud& points,
            const Eigen::Isometry3d& mapFromSensor, const VisibilityOptions& options);

  /// Asks about points given in the level frame of a scan taken at `position` [m, map frame]:
  /// x, y, z [m], shape [count]. Adds 1 to freeViews[i] where the view sees past point i in the
  /// whole neighbourhood of its pixel, to hitViews[i] where it measures the point itself.
  void testify(const float* x, const float* y, const float* z, std::size_t count,
               const Eigen::Vector3d& position, std::uint8_t* freeViews,
               std::uint8_t* hitViews) const;

 private:
  void fillRanges(const RangeImage& image, const PointCloud& points);
  void fillNearest();
  void fillRowTable(const std::vector<float>& elevations);
  void judge(float range, int row, int column, std::uint8_t& freeViews,
             std::uint8_t& hitViews) const;

  int rows_, columns_;
  float freeMargin_, freeMarginShare_, hitMargin_;
  Eigen::Isometry3d sensorFromMap_;
  /// Shortest range of each pixel and of its 3 x 3 neighbourhood [m], infinite where empty.
  std::vector<float> ranges_, nearest_;
  /// Row of each elevation step, -1 outside the field of view.
  std::vector<std::int16_t> rowOfElevation_;
};

}  // namespace toss
