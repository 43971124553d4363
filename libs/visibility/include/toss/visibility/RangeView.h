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
  /// Range in steps of 1 cm, at most 655 m: all views of some seconds are kept.
  using Steps = std::uint16_t;

  /// Working memory of look(), to be kept from scan to scan.
  struct Scratch {
    /// Shortest range of each pixel, and of it and its neighbours in the row, the most steps where
    /// empty.
    std::vector<Steps> ranges, alongRow;
    /// Longest range of each pixel and its neighbours in the row, 0 where empty.
    std::vector<Steps> farthestAlongRow;
    /// Of one row: what lies behind, see Pixel.
    std::vector<Steps> behind;
    /// Column of the view that each column of the scan's image falls into.
    std::vector<std::uint16_t> columnOf;
  };

  /// A view that has seen nothing yet.
  explicit RangeView(const VisibilityOptions& options);

  /// Replaces what was seen. `points`: the scan behind `image`, sensor frame; `mapFromSensor`: pose
  /// of the sensor then. Returns are filed by their elevation, not by the beam that made them:
  /// points are looked up by elevation, and on a robot that pitches within its sweep the two differ
  /// by several rows.
  void look(const RangeImage& image, const PointCloud& points,
            const Eigen::Isometry3d& mapFromSensor, Scratch& scratch);

  /// Asks about points given in the level frame of a scan taken at `position` [m, map frame]:
  /// x, y, z [m], shape [count]. Adds 1 to freeViews[i] where the view sees past point i in the
  /// whole neighbourhood of its pixel but for what stands far in front of it, and has returns below
  /// it of which one goes past it too, to hitViews[i] where it measures the point itself, and to
  /// glimpseViews[i] where some ray of the two rows below, in views of many rows also of its own,
  /// goes past it and none measures it: over ground at a grazing angle those above go past anyway.
  void testify(const float* x, const float* y, const float* z, std::size_t count,
               const Eigen::Vector3d& position, std::uint8_t* freeViews, std::uint8_t* hitViews,
               std::uint8_t* glimpseViews) const;

 private:
  /// Shortest range of a pixel and of its 3 x 3 neighbourhood, the most steps where empty; the
  /// longest of the rows that glimpse past it, 0 where empty; and the longest of the two rows
  /// below, or where something occludes the neighbourhood (a window's frame, a trunk) the shortest
  /// behind that if it is less, 0 where the row below is empty: side by side, since they are asked
  /// for together.
  struct Pixel {
    Steps range, nearest, farthest, behind;
  };
  void fillRowTable(const std::vector<float>& elevations);
  void fillRanges(const RangeImage& image, const PointCloud& points, Scratch& scratch) const;
  void spreadAlongRows(Scratch& scratch) const;
  void fillPixels(Scratch& scratch);
  void fillRow(int row, Scratch& scratch);

  int mostColumns_, rows_ = 0, columns_ = 0;
  /// Whether rows are near to each other.
  bool dense_ = false;
  float freeMargin_, freeMarginShare_, hitMargin_, occluderShare_;
  Eigen::Isometry3d sensorFromMap_;
  /// Shape [rows + 1, columns]; the last row is empty and stands for all outside the field of view.
  std::vector<Pixel> pixels_;
  /// Row of each step of the sine of elevation.
  std::vector<std::int16_t> rowOfSine_;
};

}  // namespace toss
