// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/PosedScan.h>
#include <toss/rawlog/InputOptions.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace toss {

/// What reading an input has found so far.
struct InputReport {
  /// Scans delivered; scans skipped because no pose lies near enough in time; scans of 0 points
  /// (delivered and counted here).
  std::uint64_t scans = 0, skippedForPose = 0, empty = 0;
  /// Scans skipped because they are not later than the one before; scans of other sensors.
  std::uint64_t skippedForTime = 0, otherSensors = 0;
  /// Scans whose returns were put where they are seen from one pose (input.deskew), and scans that
  /// have times for it but too few poses around them.
  std::uint64_t deskewed = 0, notDeskewed = 0;
  /// Returns delivered in all, and of them not finite.
  std::uint64_t points = 0, notFinite = 0;
  /// Plain sentences for the user, each once: what is odd about the input and what to do.
  std::vector<std::string> warnings;
};

/// Posed scans one at a time, in order of time, from whatever holds them; constant memory.
class ScanSource {
 public:
  virtual ~ScanSource() = default;

  /// Reads the next scan into `scan`, reusing its buffers; false at the end of the input. Throws
  /// UserError naming the file, the place in it and the remedy where the input is damaged.
  virtual bool next(PosedScan& scan) = 0;
  /// Share of the input that has been read, 0 to 1.
  virtual double progress() const = 0;
  /// Scans that the input holds where that is known before reading it, else 0.
  virtual std::uint64_t scanCount() const = 0;
  virtual const InputReport& report() const = 0;
};

/// Opens a rawlog (observations or action/sensory-frame pairs, gz or plain) or a folder in KITTI
/// layout: finds out which. Checks the input's integrity as far as that is cheap before the first
/// scan. Throws UserError where the path is neither.
std::unique_ptr<ScanSource> openScans(const std::filesystem::path& input,
                                      const InputOptions& options);

/// Where the ground-truth labels of an input lie: the folder's labels/ or <stem>_labels/ beside the
/// rawlog; empty where there are none.
std::filesystem::path labelsFolderOf(const std::filesystem::path& input);

/// <stem>_labels beside a rawlog, whether it exists or not; "a.rawlog" and "a.rawlog.gz" share it.
std::filesystem::path labelsFolderBeside(const std::filesystem::path& rawlog);

}  // namespace toss
