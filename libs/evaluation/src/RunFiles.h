// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace toss {

/// What of a run is there to be scored; empty paths for what is not.
struct RunFiles {
  std::filesystem::path labels, liveLabels, instances;
  std::filesystem::path map, tracks, timings, summary, resources;
};

/// Looks into a run's folder, or takes a file as a map. Throws UserError where nothing can be
/// scored.
RunFiles findRunFiles(const std::filesystem::path& runOrMap);

/// True boxes beside an input: tracks.csv in a folder, <stem>_tracks.csv beside a rawlog; else
/// empty.
std::filesystem::path trueTracksOf(const std::filesystem::path& truth);

}  // namespace toss
