// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace toss::simulation {

struct World;
class RandomStream;

// One function per scene, each in the file of its name.
void buildStreet(World& world, RandomStream& random);
void buildCrossing(World& world, RandomStream& random);
void buildJunction(World& world, RandomStream& random);
void buildUrban(World& world, RandomStream& random);
void buildHighway(World& world, RandomStream& random);
void buildResidential(World& world, RandomStream& random);
void buildPedestrians(World& world, RandomStream& random);
void buildDuckpond(World& world, RandomStream& random);
void buildLongStairs(World& world, RandomStream& random);
void buildSteepHills(World& world, RandomStream& random);

}  // namespace toss::simulation
