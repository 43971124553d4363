// SPDX-License-Identifier: BSD-3-Clause
// Points of a CObservationVelodyneScan, decoded from its packets by MRPT.
#include <mrpt/obs/CObservationVelodyneScan.h>
#include <toss/rawlog/ObservationPoints.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

#include "VelodyneHalves.h"
#include "VelodyneTimes.h"

namespace toss {
namespace {

using mrpt::obs::CObservationVelodyneScan;

/// Ring of each laser, 0 = topmost: lasers fire in an order of their own.
std::vector<std::uint16_t> ringOfLaser(const mrpt::obs::VelodyneCalibration& calibration) {
  const auto& lasers = calibration.laser_corrections;
  std::vector<std::uint16_t> byHeight(lasers.size()), ring(lasers.size());
  std::iota(byHeight.begin(), byHeight.end(), std::uint16_t{0});
  std::stable_sort(byHeight.begin(), byHeight.end(), [&](std::uint16_t a, std::uint16_t b) {
    return lasers[a].verticalCorrection > lasers[b].verticalCorrection;
  });
  for (std::size_t i = 0; i < byHeight.size(); ++i)
    ring[byHeight[i]] = static_cast<std::uint16_t>(i);
  return ring;
}

std::string modelOf(std::size_t lasers) {
  return lasers == 16 ? "VLP-16" : lasers == 32 ? "HDL-32E" : lasers == 64 ? "HDL-64E" : "";
}

/// The sensor with the beams of its calibration.
std::shared_ptr<const SensorModel> beamsOf(const CObservationVelodyneScan& observation,
                                           const std::string& model) {
  if (model.empty()) return nullptr;
  SensorModel beams = sensorByName(model);
  for (std::size_t i = 0; i < beams.elevations.size(); ++i)
    beams.elevations[i] = static_cast<float>(
        observation.calibration.laser_corrections[i].verticalCorrection * M_PI / 180.0);
  std::sort(beams.elevations.rbegin(), beams.elevations.rend());
  return std::make_shared<const SensorModel>(std::move(beams));
}

/// Takes the points over as MRPT decodes them.
struct Storage : CObservationVelodyneScan::PointCloudStorageWrapper {
  Storage(const CObservationVelodyneScan& observation, PointCloud& target)
      : start(observation.timestamp),
        ring(ringOfLaser(observation.calibration)),
        times(observation),
        points(target) {
    points.resize(0);
  }

  void add_point(float x, float y, float z, std::uint8_t intensity,
                 const mrpt::system::TTimeStamp& time, float azimuth,
                 std::uint16_t laser) override {
    points.x.push_back(x);
    points.y.push_back(y);
    points.z.push_back(z);
    points.intensity.push_back(static_cast<float>(intensity) / 255.0f);
    points.ring.push_back(ring.at(laser + laserOffset));
    const double elapsed = std::chrono::duration<double, std::micro>(time - start).count();
    points.time.push_back(times.timeOf(std::llround(elapsed), azimuth));
  }

  mrpt::system::TTimeStamp start;
  std::vector<std::uint16_t> ring;
  VelodyneTimes times;
  PointCloud& points;
  /// Added to MRPT's number of a laser.
  std::size_t laserOffset = 0;
};

}  // namespace

void readVelodynePoints(mrpt::obs::CObservation& observation, PosedScan& scan) {
  auto& velodyne = dynamic_cast<CObservationVelodyneScan&>(observation);
  const std::size_t lasers = velodyne.calibration.laser_corrections.size();
  Storage storage(velodyne, scan.points);
  velodyne.generatePointCloud(storage);
  if (mrptLosesSecondHalves()) {
    storage.laserOffset = lasers > 16 ? 16 : 0;
    secondHalves(velodyne).generatePointCloud(storage);
  }
  scan.sensorModel = modelOf(lasers);
  scan.beams = beamsOf(velodyne, scan.sensorModel);
}

}  // namespace toss
