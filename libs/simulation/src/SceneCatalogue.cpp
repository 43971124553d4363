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
        "residential street: houses, hedges, parked cars; oncoming, leading and crossing car, "
        "people, a cyclist",
        "HDL-64E", 60},
       buildStreet},
      {{"crossing", "small: a box-shaped car crosses, a person walks; parked car, walls", "VLP-16",
        30},
       buildCrossing},
      {{"urban",
        "town with a turn: high fronts, buses, parked cars, one that leaves, one that parks, a "
        "door that opens",
        "HDL-64E", 140},
       buildUrban},
      {{"highway",
        "motorway at 25 m/s: leading, overtaking, oncoming traffic, trucks, guard rails, gantries, "
        "a bridge",
        "HDL-64E", 100},
       buildHighway},
      {{"residential",
        "narrow street between hedges and fences: cars leave their places, people walk close to "
        "hedges",
        "HDL-64E", 90},
       buildResidential},
      {{"junction",
        "stop and go at a light: queues, a bus, trucks, many vehicles on the same lanes, people "
        "cross",
        "HDL-64E", 320},
       buildJunction},
      {{"pedestrians",
        "pedestrian street: 50 people, in groups, slow, along walls, standing; stalls, benches, "
        "bicycles",
        "HDL-64E", 160},
       buildPedestrians},
      {{"duckpond",
        "legged robot on a path around a pond: 40 people, trees, bushes, tall grass, a hedge",
        "OS0-128", 200},
       buildDuckpond},
      {{"long-stairs",
        "legged robot climbs six flights of stairs among people; landings, handrails, an arch",
        "OS0-128", 300},
       buildLongStairs},
      {{"steep-hills",
        "legged robot on slopes above 20 degrees: walkers, a mountain biker, bushes, a fence",
        "OS0-128", 250},
       buildSteepHills},
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
