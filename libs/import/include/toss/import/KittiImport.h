// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/rawlog/ScanSource.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>

namespace toss {

/// What is imported of a folder, and how it is written.
struct KittiImportOptions {
  /// First and last scan, by the number in the file name.
  std::uint64_t from = 0, to = std::numeric_limits<std::uint64_t>::max();
  /// Whether the rawlog is compressed: saves a quarter to a half of the size, and writing and
  /// reading take ten times as long or more.
  bool gz = false;
  /// Fallbacks for files that the folder lacks.
  InputOptions input;
  /// Called now and then with the share that is done, 0 to 1; may be empty.
  std::function<void(double)> progress;
};

/// What has been imported.
struct KittiImportResult {
  /// Scans written, and of them those with labels.
  std::uint64_t scans = 0, labelled = 0;
  /// What reading the folder has found.
  InputReport input;
};

/// Turns a folder in KITTI layout into a rawlog of stock MRPT classes: CObservationRobotPose and
/// CObservationPointCloud (CPointsMapXYZI) per scan. Points keep their order and their bits;
/// reading the rawlog gives the same scans as reading the folder, bit for bit. Labels go to
/// <stem>_labels beside the rawlog; scans are numbered anew from 0, labels with them. Scans without
/// a pose are left out and reported. Nothing appears under its name before all is written. Throws
/// UserError for a damaged folder, labels that do not fit, an empty choice of scans, or a full
/// disk.
KittiImportResult importKitti(const std::filesystem::path& folder,
                              const std::filesystem::path& rawlog,
                              const KittiImportOptions& options = {});

}  // namespace toss
