// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace toss::simulation {

struct World;
class RandomStream;

// One function per scene, each in the file of its name.
void buildStreet(World& world, RandomStream& random);
void buildCrossing(World& world, RandomStream& random);
void buildJunction(World& world, RandomStream& random);

}  // namespace toss::simulation
