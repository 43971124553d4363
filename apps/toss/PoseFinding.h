// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/odometry/PoseJudgement.h>

#include "CheckFinding.h"

namespace toss {

/// Says what is wrong with the poses and what to do about it; nothing where they are right.
void reportPoses(const PoseJudgement& judgement, Findings& findings);

}  // namespace toss
