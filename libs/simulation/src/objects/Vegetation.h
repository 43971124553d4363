// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../Mesh.h"
#include "../Random.h"

namespace toss::simulation {

/// A tree with a sparse canopy of loose leaves over a trunk with boughs. `height` [m].
Mesh makeTree(RandomStream& random, double height, int leaves = 1500);

/// A conifer whose leaves reach down to the ground.
Mesh makeConifer(RandomStream& random, double height);

/// A hedge along x from 0 to `length`, of random leaves with an uneven top. [m]
Mesh makeHedge(RandomStream& random, double length, double width = 0.8, double height = 1.6);

/// A round bush. [m]
Mesh makeBush(RandomStream& random, double radius, double height);

/// A bush of random size up to the given one. [m]
Mesh makeAnyBush(RandomStream& random, double maxRadius, double maxHeight);

/// Tufts of tall grass scattered over a disc. [m]
Mesh makeTallGrass(RandomStream& random, double radius, int tufts);

}  // namespace toss::simulation
