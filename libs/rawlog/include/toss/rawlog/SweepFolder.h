// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/PosedScan.h>
#include <toss/geometry/SensorModel.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>

namespace toss {

class AtomicFolder;

// What a CObservationPointCloud has no place for lies in a folder <stem>_sweeps beside the rawlog,
// so that programs that know MRPT's classes only still open the rawlog:
//
//   <label>_<time>.sweep  one file per scan. <label>: the observation's sensor label, all but
//                         letters, digits, '-' and '.' replaced by '_'. <time>: its time stamp in
//                         UNIX time [s], 7 decimals (MRPT's unit is 100 ns). Scans are found by
//                         label and time, so a log may be cut or thinned out with other programs.
//                         Content, little-endian: 8 bytes "TOSSSWP1"; uint32 points; uint32 flags
//                         (1 = rings, 2 = times, 4 = motion-compensated); with flag 1 uint16
//                         ring[points]; with flag 2 float32 time[points], [s] relative to the time
//                         stamp. Both in the order of the observation's points.
//   sensors.json          {"<label>": {"model": ..., "elevations": [rad, topmost first],
//                         "columns": ..., "min_range": [m], "max_range": [m]}, ...}

/// <stem>_sweeps beside a rawlog, whether it exists or not; "a.rawlog" and "a.rawlog.gz" share it.
std::filesystem::path sweepsFolderBeside(const std::filesystem::path& rawlog);

/// Name of the file of a scan in that folder. `time`: UNIX time [s].
std::string sweepFileName(const std::string& label, double time);

/// Whether the scan has anything that goes to the folder: rings, times, or beams.
bool hasSweep(const PosedScan& scan);

/// Writes the folder of a new rawlog; it appears under its name with commit().
class SweepFolderWriter {
 public:
  /// Throws UserError if the folder can't be made.
  explicit SweepFolderWriter(const std::filesystem::path& rawlog);
  ~SweepFolderWriter();

  /// Writes what hasSweep() asks for. `label`: sensor label of the observation. `points.ring` and
  /// `points.time` have one entry per point or none. Throws UserError if it can't be written.
  void write(const PosedScan& scan, const std::string& label);
  /// Throws UserError if it fails.
  void commit();

 private:
  std::unique_ptr<AtomicFolder> folder_;
  std::map<std::string, std::shared_ptr<const SensorModel>> beams_;
};

/// The folder beside a rawlog that is read.
class SweepFolder {
 public:
  /// Reads the beams. Throws UserError where sensors.json is damaged.
  explicit SweepFolder(const std::filesystem::path& rawlog);

  /// Adds rings, times, beams and `motionCompensated` to a scan whose points have been read.
  /// `label`: sensor label of the observation. Returns false where the folder exists, but knows
  /// nothing of this scan. Throws UserError where its file is damaged or of another scan.
  bool addTo(PosedScan& scan, const std::string& label) const;

 private:
  bool addSweep(PosedScan& scan, const std::string& label) const;

  std::filesystem::path folder_;
  bool exists_ = false;
  std::map<std::string, std::shared_ptr<const SensorModel>> beams_;
};

}  // namespace toss
