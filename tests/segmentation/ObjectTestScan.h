// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/segmentation/RangeImage.h>
#include <toss/segmentation/Segmentation.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <vector>

namespace toss::test {

/// Axis-aligned box that rays are cast at, sensor frame [m].
struct SceneBox {
  Eigen::Vector3d low, high;

  /// Distance at which a ray from the origin enters the box, none if it misses.
  std::optional<double> hit(const Eigen::Vector3d& direction) const {
    double enter = 0.0, leave = std::numeric_limits<double>::max();
    for (int axis = 0; axis < 3; ++axis) {
      const double a = low[axis] / direction[axis], b = high[axis] / direction[axis];
      enter = std::max(enter, std::min(a, b));
      leave = std::min(leave, std::max(a, b));
    }
    return enter > 0.0 && enter <= leave ? std::optional<double>(enter) : std::nullopt;
  }
};

/// A scan as the object segmentation gets it: all returns above ground, none decided.
class ObjectTestScan {
 public:
  LevelPoints points;
  RangeImage image;
  Segmentation segmentation;
  /// Number of the box that each return lies on, -1 for others.
  std::vector<int> box;

  /// An empty image with rows from elevation `top` down to `bottom` [rad].
  ObjectTestScan(int rows, int columns, double top, double bottom) {
    image.rows = rows, image.columns = columns;
    image.representative.assign(image.pixel(rows, 0), RangeImage::kNone);
    for (int r = 0; r < rows; ++r) {
      image.elevations.push_back(static_cast<float>(top + (bottom - top) * r / (rows - 1)));
    }
  }

  /// HDL-64E-like: +2 to -24.8 degrees.
  static ObjectTestScan hdl64() { return {64, 2048, 0.0349, -0.4328}; }

  std::size_t size() const { return points.x.size(); }

  /// Direction of the middle of a pixel.
  Eigen::Vector3d direction(int row, int column) const {
    const double azimuth = M_PI * (1.0 - 2.0 * (column + 0.5) / image.columns);
    const double elevation = image.elevations[static_cast<std::size_t>(row)];
    return {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
            std::sin(elevation)};
  }

  /// Appends a return at `range` [m] in the middle of a pixel. The nearest represents the pixel,
  /// the rest of the chain is in no order.
  void add(int row, int column, double range, int boxNumber = -1) {
    const Eigen::Vector3f point = (range * direction(row, column)).cast<float>();
    const std::int32_t i = static_cast<std::int32_t>(size());
    points.x.push_back(point.x()), points.y.push_back(point.y()), points.z.push_back(point.z());
    image.row.push_back(static_cast<std::uint16_t>(row));
    image.column.push_back(static_cast<std::uint16_t>(column));
    image.range.push_back(static_cast<float>(range));
    image.next.push_back(RangeImage::kNone);
    segmentation.pointClass.push_back(PointClass::Unclustered);
    box.push_back(boxNumber);
    std::int32_t& head = image.representative[image.pixel(row, column)];
    std::int32_t& link = head < 0 || range < rangeOf(head) ? head : nextOf(head);
    nextOf(i) = link;
    link = i;
  }

  /// Adds the nearest hit of every pixel's ray with `boxes`.
  void cast(const std::vector<SceneBox>& boxes) {
    for (int row = 0; row < image.rows; ++row) {
      for (int column = 0; column < image.columns; ++column) castPixel(boxes, row, column);
    }
  }

  /// Instances that the returns of a box are in, 0 for those in none.
  std::set<std::int32_t> instancesOf(int boxNumber) const {
    std::set<std::int32_t> result;
    for (std::size_t i = 0; i < size(); ++i) {
      if (box[i] == boxNumber) result.insert(segmentation.instance[i]);
    }
    return result;
  }

 private:
  float rangeOf(std::int32_t i) const { return image.range[static_cast<std::size_t>(i)]; }
  std::int32_t& nextOf(std::int32_t i) { return image.next[static_cast<std::size_t>(i)]; }

  void castPixel(const std::vector<SceneBox>& boxes, int row, int column) {
    double nearest = std::numeric_limits<double>::max();
    int hitBox = -1;
    for (std::size_t b = 0; b < boxes.size(); ++b) {
      const std::optional<double> range = boxes[b].hit(direction(row, column));
      if (!range || *range >= nearest) continue;
      nearest = *range;
      hitBox = static_cast<int>(b);
    }
    if (hitBox >= 0) add(row, column, nearest, hitBox);
  }
};

}  // namespace toss::test
