// SPDX-License-Identifier: BSD-3-Clause
#include <toss/geometry/Error.h>
#include <toss/geometry/Options.h>
#include <toss/simulation/SceneCatalogue.h>

#include "Scenes.h"
#include "scenes/SceneBuilders.h"

namespace toss {
namespace simulation {

const std::vector<Scene>& allScenes() {
  static const std::vector<Scene> scenes = {
      {{"street",
        "residential street: houses, hedge, parked cars; oncoming, leading and crossing car, "
        "people, a cyclist",
        "HDL-64E", 60},
       buildStreet},
      {{"crossing", "small: a box-shaped car crosses, a person walks; parked car, wall", "VLP-16",
        30},
       buildCrossing},
      {{"junction",
        "stop and go at a light: queues, a bus, trucks, many vehicles on the same lanes, people "
        "over the crossings",
        "HDL-64E", 320},
       buildJunction},
  };
  return scenes;
}

const Scene& findScene(const std::string& name) {
  std::vector<std::string> names;
  for (const Scene& scene : allScenes()) {
    if (scene.info.name == name) return scene;
    names.push_back(scene.info.name);
  }
  throw UserError("scene '" + name + "'", "unknown",
                  "did you mean '" + nearestName(name, names) + "'?");
}

}  // namespace simulation

std::vector<SceneInfo> knownScenes() {
  std::vector<SceneInfo> infos;
  for (const simulation::Scene& scene : simulation::allScenes()) infos.push_back(scene.info);
  return infos;
}

SceneInfo sceneByName(const std::string& name) {
  return simulation::findScene(name).info;
}

}  // namespace toss
