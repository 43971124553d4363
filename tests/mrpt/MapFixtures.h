// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/io/CMemoryStream.h>
#include <toss/mrpt/CDynamicFilteredPointsMap.h>

#include "InputFixtures.h"
#include "SimulatedScans.h"

namespace toss::test {

/// The scans of the simulated crossing, as observations.
inline const std::vector<SimulatedScan>& crossing() {
  static const std::vector<SimulatedScan> scans = crossingScans(25);
  return scans;
}

inline mrpt::poses::CPose3D poseOf(const PosedScan& scan) {
  return toMrpt(scan.mapFromSensor);
}

inline FilteredMapOptions vlp16() {
  FilteredMapOptions options;
  options.settings = {"sensor.model=VLP-16"};
  return options;
}

/// Inserts scans `from` to `to`, the latter not included.
inline void insertScans(CDynamicFilteredPointsMap& map, std::size_t from, std::size_t to) {
  for (std::size_t i = from; i < to; ++i) {
    const PosedScan& scan = crossing()[i].scan;
    EXPECT_TRUE(map.insertObservation(*cloudObservation(1.6e9 + scan.time, scan), poseOf(scan)));
  }
}

inline std::vector<MapPoint> pointsOf(const mrpt::maps::CPointsMapXYZI& map) {
  std::vector<MapPoint> points(map.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    map.getPointFast(i, points[i].x, points[i].y, points[i].z);
    points[i].intensity = map.getPointIntensity_fast(i);
  }
  return points;
}

/// What the pipeline itself makes of these scans.
inline std::vector<MapPoint> directMap(std::size_t from, std::size_t to) {
  PipelineRun run(vlp16().resolve("VLP-16").pipeline);
  for (std::size_t i = from; i < to; ++i) {
    PosedScan scan = crossing()[i].scan;
    scan.time = fromMrptTime(toMrptTime(1.6e9 + scan.time));
    run.process(scan);
  }
  run.finish();
  return run.pipeline->staticMap();
}

/// Writes the object and reads it back, as an object of the class that the stream names.
template <typename T>
typename T::Ptr writtenAndRead(const T& object) {
  mrpt::io::CMemoryStream stream;
  auto archive = mrpt::serialization::archiveFrom(stream);
  archive << object;
  stream.Seek(0);
  return std::dynamic_pointer_cast<T>(archive.ReadObject());
}

}  // namespace toss::test
