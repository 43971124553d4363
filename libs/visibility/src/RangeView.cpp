// SPDX-License-Identifier: BSD-3-Clause
#include <toss/geometry/FastAtan2.h>
#include <toss/geometry/ProcessorVariants.h>
#include <toss/visibility/RangeView.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace toss {
namespace {

constexpr float kPi = 3.14159265358979f;
constexpr float kNothing = std::numeric_limits<float>::infinity();
constexpr float kStepsPerMetre = 100.0f;
/// Also of pixels without returns.
constexpr RangeView::Steps kEmpty = std::numeric_limits<RangeView::Steps>::max();
/// Steps from the horizon to the zenith: 0.014 degrees each near the horizon, far below any row
/// spacing. The sine of elevation is z over range: no arc tangent is needed for the row.
constexpr int kHalfSineSteps = 4096;
constexpr std::size_t kSineSteps = 2 * kHalfSineSteps + 1;
/// Fewer neighbours that look past an occluder may look past the edge of something else as well.
constexpr int kFewestPastOccluder = 4;
/// Rows nearer to each other than this [rad] pass what they are nearest to closely enough to
/// glimpse past it; over ground at a grazing angle others go far although they pass well above.
constexpr float kDense = 1.0f * kPi / 180.0f;
/// Points that are worked on together.
constexpr std::size_t kBlock = 256;

float metres(RangeView::Steps steps) {
  return static_cast<float>(steps) * (1.0f / kStepsPerMetre);
}

std::int32_t sineStep(float sine) {
  return static_cast<std::int32_t>((sine + 1.0f) * static_cast<float>(kHalfSineSteps));
}

std::size_t sineStepOfElevation(float elevation) {
  return static_cast<std::size_t>(
      sineStep(std::sin(std::clamp(elevation, -0.5f * kPi, 0.5f * kPi))));
}

/// Shortest of the ranges over `limit` in the neighbourhood of column `c`, the limit if they are
/// too few. `rows`: the pixel's row and its neighbours, shape [width] each.
RangeView::Steps shortestBehind(const std::array<const RangeView::Steps*, 3>& rows, std::size_t c,
                                std::size_t width, RangeView::Steps limit) {
  RangeView::Steps shortest = kEmpty;
  int count = 0;
  const std::array<std::size_t, 3> columns = {c > 0 ? c - 1 : width - 1, c,
                                              c + 1 < width ? c + 1 : 0};
  for (const RangeView::Steps* row : rows) {
    for (const std::size_t column : columns) {
      const RangeView::Steps range = row[column];
      if (range <= limit || range == kEmpty) continue;
      ++count;
      shortest = std::min(shortest, range);
    }
  }
  return count < kFewestPastOccluder ? limit : shortest;
}

/// Where points lie in a view.
struct Block {
  std::array<float, kBlock> range;
  std::array<std::int32_t, kBlock> sine, column;
};

}  // namespace

RangeView::RangeView(const VisibilityOptions& options)
    : mostColumns_(options.columns),
      freeMargin_(static_cast<float>(options.freeMargin)),
      freeMarginShare_(static_cast<float>(options.freeMarginShare)),
      hitMargin_(static_cast<float>(options.hitMargin)),
      occluderShare_(static_cast<float>(options.occluderShare)),
      sensorFromMap_(Eigen::Isometry3d::Identity()) {}

void RangeView::look(const RangeImage& image, const PointCloud& points,
                     const Eigen::Isometry3d& mapFromSensor, Scratch& scratch) {
  rows_ = image.rows;
  columns_ = std::min(mostColumns_, image.columns);
  sensorFromMap_ = mapFromSensor.inverse();
  dense_ = rows_ > 1 && image.meanRowSpacing() < kDense;
  fillRowTable(image.elevations);
  fillRanges(image, points, scratch);
  spreadAlongRows(scratch);
  fillPixels(scratch);
}

void RangeView::fillRowTable(const std::vector<float>& elevations) {
  rowOfSine_.assign(kSineSteps, static_cast<std::int16_t>(rows_));
  for (int r = 0; r < rows_; ++r) {
    // A row reaches half-way to its neighbours, the lowest as far beyond. Over the uppermost no ray
    // passes, so that a ceiling there would look free to those below it.
    const auto at = [&](int index) { return elevations[static_cast<std::size_t>(index)]; };
    const float gapAbove = r > 0 ? at(r - 1) - at(r) : 0.0f;
    const float gapBelow = r + 1 < rows_ ? at(r) - at(r + 1) : gapAbove;
    const std::size_t low = sineStepOfElevation(at(r) - 0.5f * gapBelow);
    const std::size_t high = sineStepOfElevation(at(r) + 0.5f * gapAbove);
    for (std::size_t step = low; step <= high; ++step)
      rowOfSine_[step] = static_cast<std::int16_t>(r);
  }
}

TOSS_ALSO_FOR_AVX2
void RangeView::fillRanges(const RangeImage& image, const PointCloud& points,
                           Scratch& scratch) const {
  const auto width = static_cast<std::size_t>(columns_);
  scratch.ranges.assign(static_cast<std::size_t>(rows_ + 1) * width, kEmpty);
  scratch.columnOf.resize(static_cast<std::size_t>(image.columns));
  for (int c = 0; c < image.columns; ++c)
    scratch.columnOf[static_cast<std::size_t>(c)] =
        static_cast<std::uint16_t>(c * columns_ / image.columns);
  std::array<std::int32_t, kBlock> sine, steps;
  for (std::size_t begin = 0; begin < points.size(); begin += kBlock) {
    const std::size_t size = std::min(kBlock, points.size() - begin);
    for (std::size_t i = 0; i < size; ++i) {
      const float range = image.range[begin + i];
      sine[i] = sineStep(points.z[begin + i] / range);
      steps[i] = static_cast<std::int32_t>(
          std::min(range * kStepsPerMetre + 0.5f, static_cast<float>(kEmpty - 1)));
    }
    for (std::size_t i = 0; i < size; ++i) {
      if (image.row[begin + i] == RangeImage::kNoRow) continue;
      const auto row = static_cast<std::size_t>(rowOfSine_[static_cast<std::size_t>(sine[i])]);
      Steps& range = scratch.ranges[row * width + scratch.columnOf[image.column[begin + i]]];
      range = std::min(range, static_cast<Steps>(steps[i]));
    }
  }
  std::fill(scratch.ranges.end() - columns_, scratch.ranges.end(), kEmpty);
}

TOSS_ALSO_FOR_AVX2
void RangeView::spreadAlongRows(Scratch& scratch) const {
  const auto width = static_cast<std::size_t>(columns_);
  const auto measured = [](Steps range) { return range < kEmpty ? range : Steps{0}; };
  scratch.alongRow.resize(scratch.ranges.size());
  scratch.farthestAlongRow.resize(scratch.ranges.size());
  for (std::size_t begin = 0; begin < scratch.ranges.size(); begin += width) {
    const Steps* in = scratch.ranges.data() + begin;
    Steps* nearest = scratch.alongRow.data() + begin;
    Steps* farthest = scratch.farthestAlongRow.data() + begin;
    const auto fill = [&](std::size_t left, std::size_t c, std::size_t right) {
      nearest[c] = std::min(std::min(in[left], in[c]), in[right]);
      farthest[c] = std::max(std::max(measured(in[left]), measured(in[c])), measured(in[right]));
    };
    for (std::size_t c = 1; c + 1 < width; ++c) fill(c - 1, c, c + 1);
    fill(width - 1, 0, 1);
    fill(width - 2, width - 1, 0);
  }
}

void RangeView::fillPixels(Scratch& scratch) {
  const auto width = static_cast<std::size_t>(columns_);
  pixels_.resize(scratch.ranges.size());
  scratch.behind.resize(width);
  for (int r = 0; r < rows_; ++r) fillRow(r, scratch);
  std::fill(pixels_.end() - columns_, pixels_.end(), Pixel{kEmpty, kEmpty, 0, 0});
}

TOSS_ALSO_FOR_AVX2
void RangeView::fillRow(int r, Scratch& scratch) {
  const auto width = static_cast<std::size_t>(columns_);
  const auto row = [&](const std::vector<Steps>& values, int index) {
    return values.data() + static_cast<std::size_t>(std::max(index, 0)) * width;
  };
  // The row under the lowest is empty; its place is taken by the lowest but in glimpses.
  const int above = r - 1, under = std::min(r + 1, rows_ - 1), deeper = std::min(r + 2, rows_);
  const Steps *n0 = row(scratch.alongRow, above), *n1 = row(scratch.alongRow, r),
              *n2 = row(scratch.alongRow, under);
  const Steps *f0 = row(scratch.farthestAlongRow, above), *f1 = row(scratch.farthestAlongRow, r),
              *f2 = row(scratch.farthestAlongRow, under);
  const Steps *g1 = row(scratch.farthestAlongRow, r + 1),
              *g2 = row(scratch.farthestAlongRow, deeper), *glimpsing = dense_ ? f1 : g1;
  const std::array<const Steps*, 3> ranges = {row(scratch.ranges, above), row(scratch.ranges, r),
                                              row(scratch.ranges, under)};
  const auto nearest = [&](std::size_t c) { return std::min(std::min(n0[c], n1[c]), n2[c]); };
  // Past a surface seen at a grazing angle all rays go but those under it.
  Steps* behind = scratch.behind.data();
  for (std::size_t c = 0; c < width; ++c)
    behind[c] = n2[c] == kEmpty ? Steps{0} : std::max(g1[c], g2[c]);
  for (std::size_t c = 0; c < width; ++c) {
    const float occluders = occluderShare_ * std::max(std::max(f0[c], f1[c]), f2[c]);
    if (const Steps first = nearest(c); first < occluders)
      behind[c] =
          std::min(behind[c],
                   shortestBehind(ranges, c, width,
                                  static_cast<Steps>(static_cast<float>(first) / occluderShare_)));
  }
  Pixel* out = pixels_.data() + static_cast<std::size_t>(r) * width;
  for (std::size_t c = 0; c < width; ++c)
    out[c] = {ranges[1][c], nearest(c), std::max(std::max(g1[c], g2[c]), glimpsing[c]), behind[c]};
}

TOSS_ALSO_FOR_AVX2
void RangeView::testify(const float* x, const float* y, const float* z, std::size_t count,
                        const Eigen::Vector3d& position, std::uint8_t* freeViews,
                        std::uint8_t* hitViews, std::uint8_t* glimpseViews) const {
  const Eigen::Matrix3f r = sensorFromMap_.linear().cast<float>();
  // Subtracted in double: both positions may be far from the map's origin.
  const Eigen::Vector3f t = (sensorFromMap_ * position).cast<float>();
  Block block;
  std::array<const Pixel*, kBlock> pixels;
  std::array<Pixel, kBlock> seen;
  for (std::size_t begin = 0; begin < count; begin += kBlock) {
    const std::size_t size = std::min(kBlock, count - begin);
    for (std::size_t i = 0; i < size; ++i) {
      const float px = x[begin + i], py = y[begin + i], pz = z[begin + i];
      const float qx = r(0, 0) * px + r(0, 1) * py + r(0, 2) * pz + t.x();
      const float qy = r(1, 0) * px + r(1, 1) * py + r(1, 2) * pz + t.y();
      const float qz = r(2, 0) * px + r(2, 1) * py + r(2, 2) * pz + t.z();
      const float range = std::sqrt(qx * qx + qy * qy + qz * qz);
      const float turn = 0.5f * (1.0f - fastAtan2(qy, qx) / kPi);
      const auto column = static_cast<std::int32_t>(turn * static_cast<float>(columns_));
      block.range[i] = range;
      block.sine[i] = sineStep(qz / std::max(range, 1e-6f));
      block.column[i] = column < columns_ ? column : column - columns_;
    }
    for (std::size_t i = 0; i < size; ++i) {
      const std::int32_t row = rowOfSine_[static_cast<std::size_t>(block.sine[i])];
      pixels[i] = &pixels_[static_cast<std::size_t>(row * columns_ + block.column[i])];
      // The view has not been looked at for a while: its memory is far away.
      __builtin_prefetch(pixels[i]);
    }
    for (std::size_t i = 0; i < size; ++i) seen[i] = *pixels[i];
    for (std::size_t i = 0; i < size; ++i) {
      const float range = block.range[i], nearest = metres(seen[i].nearest);
      const float past = range + freeMargin_ + freeMarginShare_ * range;
      const float unhidden = nearest < occluderShare_ * range ? kNothing : nearest;
      const float first = std::min(unhidden, metres(seen[i].behind));
      const bool free = first > past;
      const bool hit = std::fabs(nearest - range) < hitMargin_ ||
                       std::fabs(metres(seen[i].range) - range) < hitMargin_;
      const bool glimpse = !hit && metres(seen[i].farthest) > past;
      glimpseViews[begin + i] = static_cast<std::uint8_t>(glimpseViews[begin + i] + glimpse);
      freeViews[begin + i] = static_cast<std::uint8_t>(freeViews[begin + i] + free);
      hitViews[begin + i] = static_cast<std::uint8_t>(hitViews[begin + i] + hit);
    }
  }
}

}  // namespace toss
