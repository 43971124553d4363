// SPDX-License-Identifier: BSD-3-Clause
#include "RunFiles.h"

#include <toss/geometry/Error.h>

#include <algorithm>
#include <initializer_list>

namespace fs = std::filesystem;

namespace toss {
namespace {

/// Whether there is a label file in the folder; false for no folder.
bool holdsLabels(const fs::path& folder) {
  std::error_code error;
  return std::any_of(fs::directory_iterator(folder, error), fs::directory_iterator(),
                     [](const fs::directory_entry& e) { return e.path().extension() == ".label"; });
}

fs::path labelsIn(const fs::path& folder) {
  for (const fs::path& candidate : {folder / "labels", folder / "predictions", folder}) {
    if (holdsLabels(candidate)) return candidate;
  }
  return {};
}

fs::path ifHoldsLabels(const fs::path& folder) {
  return holdsLabels(folder) ? folder : fs::path();
}

fs::path ifFile(const fs::path& file) {
  return fs::is_regular_file(file) ? file : fs::path();
}

fs::path mapIn(const fs::path& folder) {
  for (const char* name : {"static_map.ply", "static_map.pcd", "static_map.metricmap"}) {
    if (fs::is_regular_file(folder / name)) return folder / name;
  }
  return {};
}

}  // namespace

RunFiles findRunFiles(const fs::path& runOrMap) {
  RunFiles files;
  if (fs::is_regular_file(runOrMap)) {
    files.map = runOrMap;
    return files;
  }
  if (!fs::is_directory(runOrMap)) {
    throw UserError(runOrMap.string(), "there is no such file or folder",
                    "give the folder that toss map wrote, or a map as PLY or PCD");
  }
  files.labels = labelsIn(runOrMap);
  files.liveLabels = ifHoldsLabels(runOrMap / "live_labels");
  files.instances = ifHoldsLabels(runOrMap / "instances");
  files.map = mapIn(runOrMap);
  files.tracks = ifFile(runOrMap / "tracks.csv");
  files.timings = ifFile(runOrMap / "timings.csv");
  files.summary = ifFile(runOrMap / "summary.json");
  files.resources = ifFile(runOrMap / "resources.json");
  if (files.labels.empty() && files.map.empty()) {
    throw UserError(runOrMap.string(), "holds neither labels nor static_map.ply",
                    "give the folder that toss map wrote, or a folder of .label files");
  }
  return files;
}

fs::path trueTracksOf(const fs::path& truth) {
  if (fs::is_directory(truth)) return ifFile(truth / "tracks.csv");
  const fs::path folder = truth.parent_path();
  // The stem of "log.rawlog.gz" is "log", as labelsFolderOf has it.
  fs::path stem = truth.filename();
  if (stem.extension() == ".gz") stem.replace_extension();
  stem.replace_extension();
  return ifFile(folder / (stem.string() + "_tracks.csv"));
}

}  // namespace toss
