// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/simulation/Simulator.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

namespace toss {

/// How a simulated log is written.
enum class LogFormat {
  /// OUT with <stem>_labels/%06d.label and <stem>_tracks.csv beside it.
  Rawlog,
  /// Folder OUT in SemanticKITTI's layout with labels/ and tracks.csv in it.
  Kitti
};

/// "rawlog" or "kitti". Throws UserError naming the nearest of the two.
LogFormat logFormatByName(const std::string& name);

/// What a simulated log holds.
struct SimulatedLog {
  std::uint64_t scans = 0, points = 0;
  /// Returns of objects that move, and number of such objects that were seen.
  std::uint64_t movingPoints = 0, movers = 0;
};

/// Called after each scan with the number of scans made and of all.
using SimulationProgress = std::function<void(int done, int total)>;

/// Simulates a log and writes it with its labels and the true boxes of all objects seen, in the
/// columns of tracks.csv. Rawlogs are stamped from 2020-09-13 12:26:40 UTC on, folders from 0 s.
/// `secondSensor`: name of another LiDAR on the same robot, "" = none: 0.4 m behind and 0.2 m below
/// the first, turned by 90 degrees and tilted by 8, its scans half a period after those of the
/// first; for rawlogs and exact poses only. Throws UserError for options out of range and where the
/// output can't be written.
SimulatedLog simulateTo(const std::filesystem::path& output, LogFormat format,
                        const SimulationOptions& options, const SimulationProgress& progress = {},
                        const std::string& secondSensor = "");

}  // namespace toss
