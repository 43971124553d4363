// SPDX-License-Identifier: BSD-3-Clause
#include <toss/tracking/BoundingBoxes.h>
#include <toss/tracking/LShapeFit.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace toss {
namespace {

/// Interval of coordinates [m].
struct Span {
  float low = 0.0f, high = 0.0f;
  double length() const { return static_cast<double>(high - low); }
  double middle() const { return 0.5 * (static_cast<double>(low) + static_cast<double>(high)); }
  void extend(float value) { low = std::min(low, value), high = std::max(high, value); }
};

/// Interval that some values fill. Four at a time, which the compiler turns into vectors.
Span rangeOf(const std::vector<float>& values) {
  std::array<float, 4> low, high;
  low.fill(values.front()), high.fill(values.front());
  const std::size_t whole = values.size() / 4 * 4;
  for (std::size_t i = 0; i < whole; i += 4) {
    for (std::size_t k = 0; k < 4; ++k) {
      low[k] = std::min(low[k], values[i + k]);
      high[k] = std::max(high[k], values[i + k]);
    }
  }
  for (std::size_t i = whole; i < values.size(); ++i) {
    low[0] = std::min(low[0], values[i]), high[0] = std::max(high[0], values[i]);
  }
  return {std::min(std::min(low[0], low[1]), std::min(low[2], low[3])),
          std::max(std::max(high[0], high[1]), std::max(high[2], high[3]))};
}

/// Boxes one instance after the other; keeps its memory.
class InstanceBoxer {
 public:
  InstanceBoxer(const LevelPoints& points, const Segmentation& segmentation,
                const BoxOptions& options)
      : points_(points), segmentation_(segmentation), options_(options) {}

  /// Detection of instance `k` (from 1), its box in the level frame.
  Detection detect(std::int32_t k) {
    const auto slot = static_cast<std::size_t>(k);
    member_ = segmentation_.members.data() + segmentation_.memberBegin[slot - 1];
    count_ = static_cast<std::size_t>(segmentation_.memberBegin[slot] -
                                      segmentation_.memberBegin[slot - 1]);
    measure();
    if (isTrimmed() || mayFit()) gather();
    Detection detection;
    detection.instance = k;
    detection.pointCount = static_cast<std::int32_t>(count_);
    detection.box = footprint();
    const Span heights = this->heights();
    detection.box.height = heights.length();
    detection.box.center.z() = heights.middle();
    detection.background = isBackground(k, detection.box);
    return detection;
  }

 private:
  /// Finds what the members fill, and the lowest of them: the first one if several are.
  void measure() {
    const auto first = static_cast<std::size_t>(member_[0]);
    Span x{points_.x[first], points_.x[first]}, y{points_.y[first], points_.y[first]};
    Span z{points_.z[first], points_.z[first]};
    std::size_t lowest = first;
    for (std::size_t m = 1; m < count_; ++m) {
      const auto i = static_cast<std::size_t>(member_[m]);
      lowest = points_.z[i] < z.low ? i : lowest;
      x.extend(points_.x[i]), y.extend(points_.y[i]), z.extend(points_.z[i]);
    }
    xSpan_ = x, ySpan_ = y, zSpan_ = z, lowest_ = lowest;
  }

  void gather() {
    x_.resize(count_), y_.resize(count_), z_.resize(count_);
    for (std::size_t m = 0; m < count_; ++m) {
      const auto i = static_cast<std::size_t>(member_[m]);
      x_[m] = points_.x[i], y_[m] = points_.y[i], z_[m] = points_.z[i];
    }
  }

  bool mayFit() const {
    const double side = std::max(xSpan_.length(), ySpan_.length());
    return options_.mode == BoxMode::LShape && side >= options_.lShapeMinSide &&
           count_ >= static_cast<std::size_t>(options_.lShapePoints);
  }

  Box footprint() {
    const Span x = trimmed(x_, xSpan_), y = trimmed(y_, ySpan_);
    Box box;
    box.center = {x.middle(), y.middle(), 0.0};
    box.length = x.length(), box.width = y.length();
    const double side = std::max(box.length, box.width);
    const bool fit = mayFit() && side >= options_.lShapeMinSide && side <= options_.lShapeMaxSide;
    return fit ? orientedFootprint(fitLShape(x_, y_)) : box;
  }

  Box orientedFootprint(double yaw) {
    const double c = std::cos(yaw), s = std::sin(yaw);
    const auto cf = static_cast<float>(c), sf = static_cast<float>(s);
    for (std::size_t i = 0; i < x_.size(); ++i) {
      const float along = cf * x_[i] + sf * y_[i];
      y_[i] = cf * y_[i] - sf * x_[i];
      x_[i] = along;
    }
    const Span along = trimmed(x_, rangeOf(x_)), across = trimmed(y_, rangeOf(y_));
    Box box;
    box.center = {c * along.middle() - s * across.middle(),
                  s * along.middle() + c * across.middle(), 0.0};
    box.yaw = yaw, box.length = along.length(), box.width = across.length();
    if (box.width > box.length) {
      std::swap(box.length, box.width);
      box.yaw -= M_PI / 2;
    }
    return box;
  }

  Span heights() {
    Span result = trimmed(z_, zSpan_);
    const float floor = groundBelow();
    const float gap = result.low - floor;
    if (gap > 0.0f && gap <= static_cast<float>(options_.floorGap)) result.low = floor;
    return result;
  }

  /// Height above ground of the lowest point, NaN where it is not known.
  float clearance() const { return segmentation_.knownHeight(lowest_); }
  float groundBelow() const { return points_.z[lowest_] - clearance(); }

  bool isBackground(std::int32_t k, const Box& box) const {
    const bool large = std::max(box.length, box.width) > options_.maxExtent;
    const bool tall = box.height > options_.maxHeight;
    const bool floating =
        isFloating(k, static_cast<float>(options_.maxClearance), points_, segmentation_);
    return large || floating || (tall && box.length * box.width > options_.maxFootprint);
  }

  /// Returns cut off at each end.
  std::size_t cut() const {
    return static_cast<std::size_t>(options_.trim * static_cast<double>(count_));
  }
  bool isTrimmed() const {
    return cut() != 0 && count_ > static_cast<std::size_t>(options_.trimPoints);
  }

  /// Interval that the values fill, `whole`, without the share that is trimmed at either end.
  Span trimmed(const std::vector<float>& values, const Span& whole) {
    if (!isTrimmed()) return whole;
    sorted_ = values;
    const auto first = static_cast<std::ptrdiff_t>(cut());
    const float low = quantile(first);
    return {low, quantile(static_cast<std::ptrdiff_t>(count_) - 1 - first)};
  }

  float quantile(std::ptrdiff_t rank) {
    std::nth_element(sorted_.begin(), sorted_.begin() + rank, sorted_.end());
    return sorted_[static_cast<std::size_t>(rank)];
  }

  const LevelPoints& points_;
  const Segmentation& segmentation_;
  const BoxOptions& options_;
  /// Of the instance at hand: its returns, what they fill, and the lowest of them.
  const std::int32_t* member_ = nullptr;
  std::size_t count_ = 0;
  Span xSpan_, ySpan_, zSpan_;
  std::size_t lowest_ = 0;
  /// Coordinates of its returns, where they are needed one by one.
  std::vector<float> x_, y_, z_, sorted_;
};

}  // namespace

void detectInstances(const LevelPoints& points, const Segmentation& segmentation,
                     const Eigen::Vector3d& sensorPosition, const BoxOptions& options,
                     std::vector<Detection>& result) {
  options.check();
  InstanceBoxer boxer(points, segmentation, options);
  result.clear();
  for (std::int32_t k = 1; k <= segmentation.instanceCount; ++k) {
    result.push_back(boxer.detect(k));
    result.back().box.center += sensorPosition;
  }
}

}  // namespace toss
