// SPDX-License-Identifier: BSD-3-Clause
#include <toss/segmentation/LevelFrame.h>
#include <toss/segmentation/Segmenter.h>

#include <chrono>

namespace toss {
namespace {

/// Milliseconds from `start` to now; sets `start` to now.
double lap(std::chrono::steady_clock::time_point& start) {
  const auto now = std::chrono::steady_clock::now();
  const double milliseconds = std::chrono::duration<double, std::milli>(now - start).count();
  start = now;
  return milliseconds;
}

}  // namespace

Segmenter::Segmenter(const ProjectionOptions& projection, const GroundOptions& ground,
                     const ObjectOptions& objects, const SensorModel& sensor)
    : projection_(projection, sensor), ground_(ground), objects_(objects) {}

void Segmenter::segment(const PosedScan& scan, SegmentedScan& result) {
  auto start = std::chrono::steady_clock::now();
  projection_.project(scan.points, result.image, result.segmentation.pointClass);
  toLevelFrame(scan.points, scan.mapFromSensor, result.level);
  times_.projection = lap(start);
  ground_.segment(result.level, result.image, result.segmentation);
  times_.ground = lap(start);
  objects_.segment(result.level, result.image, result.segmentation);
  times_.objects = lap(start);
}

}  // namespace toss
