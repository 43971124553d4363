// SPDX-License-Identifier: BSD-3-Clause
#include <toss/geometry/FastAtan2.h>
#include <toss/visibility/RangeView.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace toss {
namespace {

constexpr float kPi = 3.14159265358979f;
constexpr float kEmpty = std::numeric_limits<float>::infinity();
/// Steps of elevation per radian in the row table: 0.02 degrees, far below any row spacing.
constexpr float kStepsPerRadian = 2865.0f;
constexpr int kElevationSteps = static_cast<int>(kPi * kStepsPerRadian) + 1;

std::size_t elevationStep(float elevation) {
  const float step = (elevation + 0.5f * kPi) * kStepsPerRadian;
  return static_cast<std::size_t>(std::clamp(step, 0.0f, static_cast<float>(kElevationSteps - 1)));
}

}  // namespace

RangeView::RangeView(const RangeImage& image, const PointCloud& points,
                     const Eigen::Isometry3d& mapFromSensor, const VisibilityOptions& options)
    : rows_(image.rows),
      columns_(std::min(options.columns, image.columns)),
      freeMargin_(static_cast<float>(options.freeMargin)),
      freeMarginShare_(static_cast<float>(options.freeMarginShare)),
      hitMargin_(static_cast<float>(options.hitMargin)),
      sensorFromMap_(mapFromSensor.inverse()) {
  fillRowTable(image.elevations);
  fillRanges(image, points);
  fillNearest();
}

void RangeView::fillRanges(const RangeImage& image, const PointCloud& points) {
  const auto width = static_cast<std::size_t>(columns_);
  ranges_.assign(static_cast<std::size_t>(rows_) * width, kEmpty);
  constexpr std::size_t kBlock = 256;
  std::array<float, kBlock> elevation;
  for (std::size_t begin = 0; begin < points.size(); begin += kBlock) {
    const std::size_t size = std::min(kBlock, points.size() - begin);
    for (std::size_t i = 0; i < size; ++i) {
      const float range = image.range[begin + i], z = points.z[begin + i];
      elevation[i] = fastAtan2(z, std::sqrt(std::max(range * range - z * z, 0.0f)));
    }
    for (std::size_t i = 0; i < size; ++i) {
      if (image.row[begin + i] == RangeImage::kNoRow) continue;
      const int row = rowOfElevation_[elevationStep(elevation[i])];
      if (row < 0) continue;
      const int column = image.column[begin + i] * columns_ / image.columns;
      float& pixel =
          ranges_[static_cast<std::size_t>(row) * width + static_cast<std::size_t>(column)];
      pixel = std::min(pixel, image.range[begin + i]);
    }
  }
}

void RangeView::fillNearest() {
  const auto width = static_cast<std::size_t>(columns_);
  std::vector<float> alongRow(ranges_.size());
  for (std::size_t begin = 0; begin < ranges_.size(); begin += width) {
    const float* in = ranges_.data() + begin;
    float* out = alongRow.data() + begin;
    for (std::size_t c = 1; c + 1 < width; ++c)
      out[c] = std::min(std::min(in[c - 1], in[c]), in[c + 1]);
    out[0] = std::min(std::min(in[width - 1], in[0]), in[1]);
    out[width - 1] = std::min(std::min(in[width - 2], in[width - 1]), in[0]);
  }
  nearest_.resize(ranges_.size());
  for (int r = 0; r < rows_; ++r) {
    const auto row = [&](int index) {
      return alongRow.data() + static_cast<std::size_t>(std::clamp(index, 0, rows_ - 1)) * width;
    };
    const float *above = row(r - 1), *here = row(r), *below = row(r + 1);
    float* out = nearest_.data() + static_cast<std::size_t>(r) * width;
    for (std::size_t c = 0; c < width; ++c)
      out[c] = std::min(std::min(above[c], here[c]), below[c]);
  }
}

void RangeView::fillRowTable(const std::vector<float>& elevations) {
  rowOfElevation_.assign(static_cast<std::size_t>(kElevationSteps), -1);
  for (int r = 0; r < rows_; ++r) {
    // A row reaches half-way to its neighbours, the outermost as far beyond as inwards.
    const auto at = [&](int index) { return elevations[static_cast<std::size_t>(index)]; };
    const float gapAbove = r > 0 ? at(r - 1) - at(r) : (rows_ > 1 ? at(0) - at(1) : 0.0f);
    const float gapBelow = r + 1 < rows_ ? at(r) - at(r + 1) : gapAbove;
    const std::size_t low = elevationStep(at(r) - 0.5f * gapBelow);
    const std::size_t high = elevationStep(at(r) + 0.5f * (r > 0 ? gapAbove : gapBelow));
    for (std::size_t step = low; step <= high; ++step)
      rowOfElevation_[step] = static_cast<std::int16_t>(r);
  }
}

void RangeView::judge(float range, int row, int column, std::uint8_t& freeViews,
                      std::uint8_t& hitViews) const {
  const auto pixel = static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                     static_cast<std::size_t>(column);
  const float nearest = nearest_[pixel];
  if (nearest == kEmpty) return;
  const bool seenThrough = nearest > range + freeMargin_ + freeMarginShare_ * range;
  const bool seen =
      std::fabs(nearest - range) < hitMargin_ || std::fabs(ranges_[pixel] - range) < hitMargin_;
  freeViews = static_cast<std::uint8_t>(freeViews + (seenThrough ? 1 : 0));
  hitViews = static_cast<std::uint8_t>(hitViews + (seen ? 1 : 0));
}

void RangeView::testify(const float* x, const float* y, const float* z, std::size_t count,
                        const Eigen::Vector3d& position, std::uint8_t* freeViews,
                        std::uint8_t* hitViews) const {
  const Eigen::Matrix3f r = sensorFromMap_.linear().cast<float>();
  // Subtracted in double: both positions may be far from the map's origin.
  const Eigen::Vector3f t = (sensorFromMap_ * position).cast<float>();
  constexpr std::size_t kBlock = 256;
  std::array<float, kBlock> range, azimuth, elevation;
  for (std::size_t begin = 0; begin < count; begin += kBlock) {
    const std::size_t size = std::min(kBlock, count - begin);
    for (std::size_t i = 0; i < size; ++i) {
      const float px = x[begin + i], py = y[begin + i], pz = z[begin + i];
      const float qx = r(0, 0) * px + r(0, 1) * py + r(0, 2) * pz + t.x();
      const float qy = r(1, 0) * px + r(1, 1) * py + r(1, 2) * pz + t.y();
      const float qz = r(2, 0) * px + r(2, 1) * py + r(2, 2) * pz + t.z();
      const float horizontal = std::sqrt(qx * qx + qy * qy);
      range[i] = std::sqrt(horizontal * horizontal + qz * qz);
      azimuth[i] = fastAtan2(qy, qx);
      elevation[i] = fastAtan2(qz, horizontal);
    }
    for (std::size_t i = 0; i < size; ++i) {
      const int row = rowOfElevation_[elevationStep(elevation[i])];
      if (row < 0) continue;
      const int column =
          static_cast<int>(0.5f * (1.0f - azimuth[i] / kPi) * static_cast<float>(columns_));
      judge(range[i], row, column % columns_, freeViews[begin + i], hitViews[begin + i]);
    }
  }
}

}  // namespace toss
