// SPDX-License-Identifier: BSD-3-Clause
#include <toss/voting/FusedDecision.h>

namespace toss {
namespace {

bool isSeenThrough(const FreeSpaceSum& evidence, double share, const DecisionOptions& options) {
  return evidence.cells >= options.minCells && evidence.freeShare() >= share;
}

/// Next to nothing of it seen through, and most of it measured again.
bool isConfirmedStanding(const FreeSpaceSum& evidence, const DecisionOptions& options) {
  constexpr double kNextToNothing = 0.1;
  return evidence.hitShare() >= options.vetoHitShare && evidence.freeShare() < kNextToNothing;
}

}  // namespace

MotionClass fuseTrace(MotionClass motion, const FreeSpaceSum& evidence,
                      const DecisionOptions& options) {
  if (isSeenThrough(evidence, options.traceFreeShare, options)) return MotionClass::Strong;
  if (motion == MotionClass::Weak && isConfirmedStanding(evidence, options))
    return MotionClass::Static;
  return motion;
}

bool fuseInstance(bool voted, MotionClass trace, const FreeSpaceSum& evidence,
                  const DecisionOptions& options) {
  if (isSeenThrough(evidence, options.freeShare, options)) return true;
  if (voted && trace != MotionClass::Strong && isConfirmedStanding(evidence, options)) return false;
  return voted;
}

}  // namespace toss
