// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/pipeline/ScanLabels.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

namespace toss {

/// Writes tracks.csv scan by scan: one row per trace alive in the scan, with the columns
/// scan,time,track,class,x,y,z,yaw,l,w,h,vx,vy,vz; class is "static" or "moving"; [m, rad, m/s, s],
/// map frame. Six decimals for the time, four for the rest, a point as decimal sign everywhere.
class TracksCsvWriter {
 public:
  /// Throws UserError where the file can not be written; so do the other members.
  explicit TracksCsvWriter(const std::filesystem::path& file);
  ~TracksCsvWriter();

  void add(const ScanLabels& labels);
  /// Puts the file in place. To be called once, last; without it nothing is left behind.
  void finish();

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// One row of tracks.csv.
struct TrackRow {
  /// Number of the scan and its time [s].
  std::uint64_t scan = 0;
  double time = 0.0;
  /// `updated` is not in the file: always true.
  TrackSample sample;
};

/// Reads what TracksCsvWriter wrote, in the file's order. Columns are found by name, so further
/// ones do not matter. Throws UserError naming the line and what is wrong with it.
std::vector<TrackRow> readTracksCsv(const std::filesystem::path& file);

}  // namespace toss
