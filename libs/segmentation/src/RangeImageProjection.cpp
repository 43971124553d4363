// SPDX-License-Identifier: BSD-3-Clause
#include <toss/geometry/FastAtan2.h>
#include <toss/geometry/ProcessorVariants.h>
#include <toss/segmentation/RangeImageProjection.h>

#include <algorithm>
#include <limits>

namespace toss {
namespace {

constexpr float kPi = 3.14159265358979f;
constexpr int kColumnsOfUnknownSensor = 2048;

ProjectionOptions checked(ProjectionOptions options, const SensorModel& sensor) {
  options.check();
  if (options.columns == 0) options.columns = sensor.columns;
  if (options.columns <= 0) options.columns = kColumnsOfUnknownSensor;
  if (options.minRange == 0.0) options.minRange = static_cast<double>(sensor.minRange);
  if (options.maxRange == 0.0) options.maxRange = static_cast<double>(sensor.maxRange);
  if (options.maxRange == 0.0) options.maxRange = std::numeric_limits<float>::max();
  return options;
}

// The compiler vectorises these only as functions of arrays that are known not to overlap.

TOSS_ALSO_FOR_AVX2
void findAzimuths(const float* __restrict x, const float* __restrict y, std::size_t n,
                  float* __restrict azimuth) {
  for (std::size_t i = 0; i < n; ++i) azimuth[i] = fastAtan2(y[i], x[i]);
}

TOSS_ALSO_FOR_AVX2
void findDistances(const float* __restrict x, const float* __restrict y, const float* __restrict z,
                   std::size_t n, float* __restrict distance, float* __restrict slope) {
  for (std::size_t i = 0; i < n; ++i) {
    const float horizontalSquared = x[i] * x[i] + y[i] * y[i];
    distance[i] = std::sqrt(horizontalSquared + z[i] * z[i]);
    slope[i] = z[i] / std::max(std::sqrt(horizontalSquared), 1e-20f);
  }
}

/// Written so that it is false for NaN. An infinite distance is too far rather than invalid where
/// the coordinates themselves are finite.
TOSS_ALSO_FOR_AVX2
void findValid(const float* __restrict x, const float* __restrict y, const float* __restrict z,
               const float* __restrict distance, std::size_t n, std::uint8_t* __restrict valid) {
  for (std::size_t i = 0; i < n; ++i) {
    const bool finite = (x[i] - x[i]) + (y[i] - y[i]) + (z[i] - z[i]) == 0.0f;
    valid[i] = static_cast<std::uint8_t>(finite & (distance[i] > 0.0f));
  }
}

/// 0, as for an azimuth of pi, for returns that are in no pixel.
TOSS_ALSO_FOR_AVX2
void findColumns(const float* __restrict azimuth, const PointClass* __restrict pointClass,
                 std::size_t n, int columns, std::uint16_t* __restrict column) {
  for (std::size_t i = 0; i < n; ++i) {
    const bool inPixel = pointClass[i] == PointClass::Unclustered;
    column[i] = static_cast<std::uint16_t>(columnOfAzimuth(inPixel ? azimuth[i] : kPi, columns));
  }
}

}  // namespace

float azimuthOfColumn(int column, int columns) {
  return kPi * (1.0f - (2.0f * static_cast<float>(column) + 1.0f) / static_cast<float>(columns));
}

RangeImageProjection::RangeImageProjection(const ProjectionOptions& options,
                                           const SensorModel& sensor)
    : options_(checked(options, sensor)), sensor_(sensor), rows_(sensor, options.rowSource) {}

void RangeImageProjection::project(const PointCloud& points, RangeImage& image,
                                   std::vector<PointClass>& pointClass) {
  image.rows = sensor_.rows();
  image.columns = options_.columns;
  findDirections(points, image.range);
  rowSource_ = rows_.assign(directions_, points.ring, image.row, image.elevations);
  classify(points, image, pointClass);
  fillPixels(pointClass, image);
}

void RangeImageProjection::findDirections(const PointCloud& points, std::vector<float>& range) {
  const std::size_t n = points.size();
  directions_.azimuth.resize(n), directions_.slope.resize(n), directions_.valid.resize(n);
  range.resize(n);
  const float* const x = points.x.data();
  const float* const y = points.y.data();
  const float* const z = points.z.data();
  findAzimuths(x, y, n, directions_.azimuth.data());
  findDistances(x, y, z, n, range.data(), directions_.slope.data());
  findValid(x, y, z, range.data(), n, directions_.valid.data());
}

TOSS_ALSO_FOR_AVX2
void RangeImageProjection::classify(const PointCloud& points, RangeImage& image,
                                    std::vector<PointClass>& pointClass) {
  const std::size_t n = points.size();
  const auto minRange = static_cast<float>(options_.minRange);
  const auto maxRange = static_cast<float>(options_.maxRange);
  const auto minZ = static_cast<float>(options_.minZ), maxZ = static_cast<float>(options_.maxZ);
  const auto egoSquared = static_cast<float>(options_.egoRadius * options_.egoRadius);
  pointClass.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const float x = points.x[i], y = points.y[i], z = points.z[i];
    const bool invalid = (directions_.valid[i] == 0) | (x * x + y * y < egoSquared);
    const bool outside =
        (image.range[i] < minRange) | (image.range[i] > maxRange) | (z < minZ) | (z > maxZ);
    const PointClass unlessInvalid = outside ? PointClass::OutOfRange : PointClass::Unclustered;
    pointClass[i] = invalid ? PointClass::Invalid : unlessInvalid;
  }
}

void RangeImageProjection::fillPixels(const std::vector<PointClass>& pointClass,
                                      RangeImage& image) const {
  const std::size_t n = pointClass.size();
  image.next.assign(n, RangeImage::kNone);
  image.column.resize(n);
  findColumns(directions_.azimuth.data(), pointClass.data(), n, image.columns, image.column.data());
  image.representative.assign(image.pixel(image.rows, 0), RangeImage::kNone);
  for (std::size_t i = 0; i < n; ++i) {
    if (pointClass[i] != PointClass::Unclustered) {
      image.row[i] = RangeImage::kNoRow;
      if (pointClass[i] == PointClass::Invalid) image.range[i] = 0.0f;
      continue;
    }
    std::int32_t& head = image.representative[image.pixel(image.row[i], image.column[i])];
    const auto point = static_cast<std::int32_t>(i);
    if (head == RangeImage::kNone) {
      head = point;
    } else if (image.range[i] < image.range[static_cast<std::size_t>(head)]) {
      image.next[i] = head;
      head = point;
    } else {
      image.next[i] = image.next[static_cast<std::size_t>(head)];
      image.next[static_cast<std::size_t>(head)] = point;
    }
  }
}

}  // namespace toss
