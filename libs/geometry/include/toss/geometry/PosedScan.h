// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/PointCloud.h>
#include <toss/geometry/SensorModel.h>

#include <Eigen/Geometry>
#include <cstdint>
#include <memory>
#include <string>

namespace toss {

/// One scan with the pose of its sensor: what every input is turned into, and the only thing that
/// the pipeline takes.
struct PosedScan {
  /// Number of the scan in its input, counted from 0 over all scans found there, skipped ones
  /// included: names the label file of the scan.
  std::uint64_t index = 0;
  /// Time stamp of the scan [s]: UNIX time for rawlogs, times.txt for KITTI folders.
  double time = 0.0;
  /// Pose of the sensor in the map (map <- sensor), [m].
  Eigen::Isometry3d mapFromSensor = Eigen::Isometry3d::Identity();
  /// Pose of the sensor on the robot (robot <- sensor), [m]; identity where the input has none.
  Eigen::Isometry3d robotFromSensor = Eigen::Isometry3d::Identity();
  /// Returns in the sensor frame.
  PointCloud points;
  /// Label of the sensor in the input ("" where it has none), for logs with several sensors.
  std::string sensorLabel;
  /// Name of a sensor model of config/sensors ("HDL-64E", "VLP-16"), "" where the input does not
  /// tell which sensor it was.
  std::string sensorModel;
  /// Beams of the sensor as the input describes them (a calibration, a sensor's metadata); null
  /// where it does not.
  std::shared_ptr<const SensorModel> beams;
  /// Whether all returns are where they were seen from the pose at `time` (de-skewed), although
  /// points.time tells that they were measured at other times.
  bool motionCompensated = false;
};

}  // namespace toss
