// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/PointCloud.h>
#include <toss/geometry/SensorModel.h>
#include <toss/segmentation/ProjectionOptions.h>
#include <toss/segmentation/RangeImage.h>
#include <toss/segmentation/RowAssignment.h>
#include <toss/segmentation/Segmentation.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace toss {

/// Column of an azimuth [rad] in [-pi, pi] in an image of that many columns (paper Eq. 1, u);
/// -pi and pi both give column 0.
inline int columnOfAzimuth(float azimuth, int columns) {
  constexpr float kTurnsPerRadian = 0.159154943f;
  const float turned = 0.5f - azimuth * kTurnsPerRadian;
  const int column = static_cast<int>(turned * static_cast<float>(columns));
  return column >= columns ? column - columns : std::max(column, 0);
}

/// Azimuth [rad] of the middle of a column.
float azimuthOfColumn(int column, int columns);

/// Stage 1: filters the returns of a scan and lays them out by beam and azimuth (paper Eq. 1 with
/// the corrections of spec section 1.2). Keeps its buffers from scan to scan.
class RangeImageProjection {
 public:
  /// Throws UserError for options out of range and for a sensor without beams.
  RangeImageProjection(const ProjectionOptions& options, const SensorModel& sensor);

  /// Fills `image` and sets `pointClass` (shape [n]) to Invalid or OutOfRange where it applies;
  /// every other return is Unclustered, i.e. not yet decided. `points`: sensor frame [m]. Throws
  /// UserError where the scan's rings are not the sensor's.
  void project(const PointCloud& points, RangeImage& image, std::vector<PointClass>& pointClass);

  /// What the rows of the last scan were taken from.
  RowSource rowSource() const { return rowSource_; }

 private:
  void findDirections(const PointCloud& points, std::vector<float>& range);
  void classify(const PointCloud& points, RangeImage& image, std::vector<PointClass>& pointClass);
  void fillPixels(const std::vector<PointClass>& pointClass, RangeImage& image) const;

  ProjectionOptions options_;
  SensorModel sensor_;
  RowAssignment rows_;
  RowSource rowSource_ = RowSource::Elevation;
  Directions directions_;
};

}  // namespace toss
