// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace toss {

/// What is imported of a capture, and how it is written.
struct VelodyneImportOptions {
  /// "VLP16", "HDL32" or "HDL64".
  std::string model;
  /// Calibration of the sensor, the maker's .xml or a .yaml of the ROS driver; empty takes MRPT's
  /// for the model. An HDL-64E needs its own.
  std::filesystem::path calibration;
  /// UDP port that the data packets were sent to; 0 takes any.
  std::uint16_t port = 0;
  /// IPv4 address of the sensor, "192.168.1.201"; empty takes any.
  std::string source;
  /// Sensor label of the scans; positions get the same with "_GPS" behind it.
  std::string label = "VELODYNE";
  /// Pose of the sensor on the robot (robot <- sensor) [m].
  Eigen::Isometry3d robotFromSensor = Eigen::Isometry3d::Identity();
  /// Whether the rawlog is compressed.
  bool gz = false;
  /// Called now and then with the share that is done, 0 to 1; may be empty.
  std::function<void(double)> progress;
};

/// What has been imported.
struct VelodyneImportResult {
  /// Scans written and the data packets in them; positions written.
  std::uint64_t scans = 0, packets = 0, positions = 0;
  /// Whether time stamps are those of the satellites, else of the capturing computer.
  bool satelliteTime = false;
  /// Whether the sensor gave two returns per firing.
  bool dualReturn = false;
  /// Plain sentences for the user: what is odd about the capture.
  std::vector<std::string> warnings;
};

/// Turns a capture (pcap, pcapng) of the packets of one Velodyne sensor into a rawlog: a
/// mrpt::obs::CObservationVelodyneScan per revolution, packets as they came, with the calibration;
/// position packets that hold a sentence of a GPS receiver as CObservationGPS. A revolution begins
/// where the azimuth passes 0; the first and the last may be parts of one. Time stamps are those of
/// a revolution's first firing: satellite time where the receiver's sentences are valid and agree
/// with the sensor's clock, else the time of capture. The rawlog holds no poses. Nothing appears
/// under its name before all is written. Throws UserError for a file that is no capture or holds no
/// such packets, for packets of another model, of several sensors to choose from, for a calibration
/// that can't be read or is of another model, or a full disk.
VelodyneImportResult importVelodyne(const std::filesystem::path& capture,
                                    const std::filesystem::path& rawlog,
                                    const VelodyneImportOptions& options);

}  // namespace toss
