// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/evaluation/MethodRun.h>

namespace toss {

/// Whether this program was built with OctoMap.
bool hasOctoMap();

/// OctoMap in cells of 0.2 m with its default probabilities and no notion of ground, the paper's
/// row "OctoMap 0.2": a return stays if its cell is occupied when all scans are in. Every ray is
/// cast to its end. Throws std::logic_error without OctoMap.
MethodRun runOctoMap(const LabelledLog& log);

}  // namespace toss
