// SPDX-License-Identifier: BSD-3-Clause
#include <toss/voting/FusedDecision.h>

namespace toss {
namespace {

bool isSeenThrough(const FreeSpaceSum& evidence, double share, const DecisionOptions& options) {
  return evidence.free >= options.minCells && evidence.freeShare() >= share;
}

/// Much of it measured again, and next to nothing seen through: a wall whose visible part slides
/// along behind a window moves like this, however far it seems to travel.
bool isConfirmedStanding(const FreeSpaceSum& evidence, double freeShare,
                         const DecisionOptions& options) {
  return evidence.cells >= options.minCells && evidence.hitShare() >= options.vetoHitShare &&
         evidence.freeShare() < freeShare;
}

/// What moves behind a bush is glimpsed past; a patch of wall seen through an opening is not.
bool isGlimpsedPast(const FreeSpaceSum& evidence, const DecisionOptions& options) {
  return evidence.glimpsed >= options.minCells &&
         evidence.glimpsedShare() >= options.doubtfulGlimpsedShare;
}

}  // namespace

MotionClass fuseTrace(MotionClass motion, const FreeSpaceSum& evidence,
                      const FreeSpaceSum& whileFast, const DecisionOptions& options) {
  if (isSeenThrough(evidence, options.traceFreeShare, options)) return MotionClass::Strong;
  if (isConfirmedStanding(evidence, options.vetoFreeShare, options) ||
      isConfirmedStanding(whileFast, options.confirmFreeShare, options))
    return MotionClass::Static;
  if (motion == MotionClass::Doubtful)
    return isGlimpsedPast(evidence, options) ? MotionClass::Strong : MotionClass::Static;
  const bool confirmed = isSeenThrough(evidence, options.confirmFreeShare, options);
  return isDynamic(motion) && confirmed ? MotionClass::Strong : motion;
}

bool fuseInstance(bool voted, MotionClass trace, const FreeSpaceSum& evidence,
                  const DecisionOptions& options) {
  if (isSeenThrough(evidence, options.freeShare, options)) return true;
  // What moves at some time in its life may stand now; only a vote of others can be taken back.
  return voted &&
         (isDynamic(trace) || !isConfirmedStanding(evidence, options.confirmFreeShare, options));
}

bool isWellKnown(int scans, const FreeSpaceSum& evidence, const DecisionOptions& options) {
  return scans >= options.claimScans || isSeenThrough(evidence, options.claimFreeShare, options);
}

}  // namespace toss
