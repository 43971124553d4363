// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/segmentation/RangeImage.h>
#include <toss/segmentation/Segmentation.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace toss {

/// Axis-aligned boxes that a small sensor (32 rows over +-20 degrees, 1024 columns) looks at: the
/// ranges follow in closed form.
class AnalyticScene {
 public:
  static constexpr int kRows = 32, kColumns = 1024;
  static constexpr double kHalfFieldOfView = 20.0 * M_PI / 180.0;

  void add(const Eigen::AlignedBox3d& box) { boxes_.push_back(box); }

  static double elevation(int row) { return kHalfFieldOfView * (1.0 - 2.0 * row / (kRows - 1)); }

  /// Direction of the middle of a pixel in the sensor frame, which is parallel to the map frame.
  static Eigen::Vector3d direction(int row, int column) {
    const double azimuth = M_PI * (1.0 - 2.0 * (column + 0.5) / kColumns);
    const double e = elevation(row);
    return {std::cos(e) * std::cos(azimuth), std::cos(e) * std::sin(azimuth), std::sin(e)};
  }

  /// Distance of the first surface [m], infinite where there is none.
  double cast(const Eigen::Vector3d& from, const Eigen::Vector3d& along) const {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Eigen::AlignedBox3d& box : boxes_) {
      const Eigen::Array3d a = (box.min() - from).array() / along.array();
      const Eigen::Array3d b = (box.max() - from).array() / along.array();
      const double enter = a.min(b).maxCoeff(), leave = a.max(b).minCoeff();
      if (enter > 0.0 && enter <= leave) nearest = std::min(nearest, enter);
    }
    return nearest;
  }

  /// The image seen from `from`, and the returns behind it in the level frame.
  RangeImage look(const Eigen::Vector3d& from, LevelPoints& points) const {
    RangeImage image;
    image.rows = kRows, image.columns = kColumns;
    image.representative.assign(std::size_t{kRows} * kColumns, RangeImage::kNone);
    for (int r = 0; r < kRows; ++r) {
      image.elevations.push_back(static_cast<float>(elevation(r)));
      for (int c = 0; c < kColumns; ++c) {
        const double range = cast(from, direction(r, c));
        if (std::isinf(range)) continue;
        image.representative[image.pixel(r, c)] = static_cast<std::int32_t>(points.x.size());
        const Eigen::Vector3f p = (range * direction(r, c)).cast<float>();
        points.x.push_back(p.x()), points.y.push_back(p.y()), points.z.push_back(p.z());
        image.range.push_back(static_cast<float>(range));
        image.row.push_back(static_cast<std::uint16_t>(r));
        image.column.push_back(static_cast<std::uint16_t>(c));
      }
    }
    return image;
  }

 private:
  std::vector<Eigen::AlignedBox3d> boxes_;
};

}  // namespace toss
