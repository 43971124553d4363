// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace toss {

/// What a folder of PCD files is turned into.
struct PcdImportOptions {
  /// Frame of the coordinates in the files.
  enum class Frame {
    Map,    ///< already moved by the sensor's pose, as DynamicMap_Benchmark has it
    Sensor  ///< as the sensor measured them
  };
  Frame frame = Frame::Map;
  /// Whether the field intensity holds labels: 0 static, 1 moving (DynamicMap_Benchmark). The scans
  /// then have no intensity.
  bool labelsFromIntensity = false;
  /// Poses of the sensor (TUM or KITTI) to use instead of the files' VIEWPOINT; "" = VIEWPOINT.
  std::filesystem::path poses;
  /// Time between consecutive scans [s]: PCD files have no time. Files named by whole numbers are
  /// that many periods after 0, others by their order.
  double period = 0.1;
  /// Label of the sensor in the rawlog; "" = "LIDAR".
  std::string sensorLabel;
  /// Whether the rawlog is compressed.
  bool gz = false;
  /// Called now and then with the share that is done, 0 to 1; may be empty.
  std::function<void(double)> progress;
};

/// What has been imported.
struct PcdImportResult {
  /// Scans written; scans left out because `poses` has none for them.
  std::uint64_t scans = 0, withoutPose = 0;
  /// Returns written, and of them those labelled moving.
  std::uint64_t points = 0, moving = 0;
  /// Plain sentences for the user: what is odd, and what to do.
  std::vector<std::string> warnings;
};

/// Turns a folder of PCD files (ascii, binary, binary_compressed), one per scan, into a rawlog: a
/// CObservationRobotPose and a CObservationPointCloud in the sensor frame per scan, labels in
/// <stem>_labels. `folder` holds the files, or a folder pcd/ with them. The pose of the sensor is
/// the line VIEWPOINT. Nothing appears under its name before all is written. Throws UserError for a
/// folder without PCD files, files that can't be read, have no pose, or other labels than 0 and 1,
/// and a full disk.
PcdImportResult importPcd(const std::filesystem::path& folder, const std::filesystem::path& rawlog,
                          const PcdImportOptions& options = {});

}  // namespace toss
