// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace toss {

/// What a list of the procedural scenes shows of each.
struct SceneInfo {
  /// Name as it is given on the command line, e.g. "street".
  std::string name;
  /// One sentence: what is in it.
  std::string description;
  /// Sensor that is used where none is asked for (a name of knownSensors()).
  std::string sensor;
  /// Number of scans that are made where no number is asked for.
  int frames = 0;
};

/// All scenes, in the order in which they are listed.
std::vector<SceneInfo> knownScenes();

/// The scene of that name. Throws UserError naming the nearest known name.
SceneInfo sceneByName(const std::string& name);

}  // namespace toss
