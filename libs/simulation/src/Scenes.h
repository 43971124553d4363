// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/simulation/SceneCatalogue.h>

#include <vector>

#include "Random.h"
#include "World.h"

namespace toss::simulation {

/// A scene with the function that builds it.
struct Scene {
  SceneInfo info;
  void (*build)(World& world, RandomStream& random);
};

const std::vector<Scene>& allScenes();

/// Throws UserError naming the nearest known name.
const Scene& findScene(const std::string& name);

}  // namespace toss::simulation
