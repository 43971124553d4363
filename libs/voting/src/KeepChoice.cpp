// SPDX-License-Identifier: BSD-3-Clause
#include <toss/geometry/Error.h>
#include <toss/voting/KeepChoice.h>

namespace toss {
namespace {

void leanTowardsStatic(DecisionOptions& decision) {
  decision.freeShare = 0.7;
  decision.traceFreeShare = decision.liveFreeShare = 0.5;
  decision.doubtfulGlimpsedShare = 0.8;
  decision.vetoHitShare = 0.15;
  decision.vetoFreeShare = 0.1;
  decision.loneFreeViews = 8;
  decision.residueMargin = 0.1;
}

void leanTowardsRemoval(DecisionOptions& decision) {
  decision.freeShare = 0.3;
  decision.traceFreeShare = decision.liveFreeShare = 0.2;
  decision.confirmFreeShare = 0.05;
  decision.doubtfulGlimpsedShare = 0.1;
  decision.vetoHitShare = 0.7;
  decision.loneFreeViews = 3;
  decision.residueMargin = 0.3;
}

}  // namespace

Keep keepFromName(const std::string& name) {
  if (name == "static") return Keep::Static;
  if (name == "balanced") return Keep::Balanced;
  if (name == "remove") return Keep::Remove;
  throw UserError("--keep " + name + ": there is no such choice; use static, balanced or remove");
}

void leanTowards(Keep keep, DecisionOptions& decision) {
  if (keep == Keep::Static) leanTowardsStatic(decision);
  if (keep == Keep::Remove) leanTowardsRemoval(decision);
}

}  // namespace toss
