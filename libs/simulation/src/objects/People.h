// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../Figure.h"
#include "../Random.h"

namespace toss::simulation {

/// A person with head, trunk, and arms and legs that swing with the way walked.
/// `height` [m]; `stride`: way of two steps [m], short for slow walkers.
Figure makePedestrian(double height = 1.75, double stride = 1.4);

/// A person of random height and stride.
Figure makePedestrian(RandomStream& random);

/// A bicycle with a rider whose legs pedal.
Figure makeCyclist();

}  // namespace toss::simulation
