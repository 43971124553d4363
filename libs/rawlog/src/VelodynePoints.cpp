// SPDX-License-Identifier: BSD-3-Clause
// Points of a CObservationVelodyneScan, decoded from its packets by MRPT.
#include <mrpt/obs/CObservationVelodyneScan.h>
#include <toss/rawlog/ObservationPoints.h>

#include <algorithm>
#include <numeric>

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

/// Takes the points over as MRPT decodes them.
struct Storage : CObservationVelodyneScan::PointCloudStorageWrapper {
  Storage(const CObservationVelodyneScan& observation, PointCloud& target)
      : start(observation.timestamp), ring(ringOfLaser(observation.calibration)), points(target) {
    points.resize(0);
  }

  void add_point(float x, float y, float z, std::uint8_t intensity,
                 const mrpt::system::TTimeStamp& time, float, std::uint16_t laser) override {
    points.x.push_back(x);
    points.y.push_back(y);
    points.z.push_back(z);
    points.intensity.push_back(static_cast<float>(intensity) / 255.0f);
    points.ring.push_back(laser < ring.size() ? ring[laser] : laser);
    points.time.push_back(static_cast<float>(std::chrono::duration<double>(time - start).count()));
  }

  mrpt::system::TTimeStamp start;
  std::vector<std::uint16_t> ring;
  PointCloud& points;
};

}  // namespace

void readVelodynePoints(mrpt::obs::CObservation& observation, PosedScan& scan) {
  auto& velodyne = dynamic_cast<CObservationVelodyneScan&>(observation);
  Storage storage(velodyne, scan.points);
  CObservationVelodyneScan::TGeneratePointCloudParameters parameters;
  parameters.generatePerPointTimestamp = true;
  parameters.generatePerPointAzimuth = true;
  velodyne.generatePointCloud(storage, parameters);
  scan.sensorModel = modelOf(velodyne.calibration.laser_corrections.size());
}

}  // namespace toss
