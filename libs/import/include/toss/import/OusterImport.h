// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/import/OusterFrames.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace toss {

/// What an Ouster capture is turned into.
struct OusterImportOptions {
  /// Poses of the sensor's housing in the map (TUM by time, KITTI by number of the frame); "" =
  /// none: the rawlog then holds no poses. TUM times before 2001 are those of a sensor that counts
  /// from its start.
  std::filesystem::path poses;
  /// A frame's time may lie between two poses of a TUM file if both are at most this far away [s].
  double maxPoseGap = 0.2;
  /// Label of the sensor in the rawlog; "" = its model, e.g. "OS1-64".
  std::string sensorLabel;
  /// Whether the rawlog is compressed.
  bool gz = false;
  /// Called now and then with the share that is done, 0 to 1; may be empty.
  std::function<void(double)> progress;
};

/// What has been imported.
struct OusterImportResult {
  /// Scans written; of them those with a pose; frames left out because the pose file has no pose
  /// for them, or because they are not later than the one before.
  std::uint64_t scans = 0, posed = 0, withoutPose = 0, notLater = 0;
  /// Returns written.
  std::uint64_t points = 0;
  OusterFrameReport frames;
  /// Plain sentences for the user: all that is odd, and what was done about it.
  std::vector<std::string> warnings;
};

/// Turns a capture of one Ouster sensor and the metadata of that sensor into a rawlog of stock MRPT
/// classes: a CObservationPointCloud per frame with the LiDAR's pose in the housing, and a
/// CObservationRobotPose of the housing where `poses` are given. Rings, times and beams go to
/// <stem>_sweeps. Time stamps are those of the sensor where it is synchronised (UNIX time); where
/// it counts from its start, they are moved to UNIX time by the capture's clock, once for all
/// frames. Nothing appears under its name before all is written. Throws UserError for what can't be
/// read or does not belong together, a capture without frames, and a full disk.
OusterImportResult importOuster(const std::filesystem::path& capture,
                                const std::filesystem::path& metadata,
                                const std::filesystem::path& rawlog,
                                const OusterImportOptions& options = {});

}  // namespace toss
