// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <toss/geometry/Error.h>
#include <toss/voting/FusedDecision.h>
#include <toss/voting/KeepChoice.h>

namespace toss {
namespace {

DecisionOptions optionsOf(Keep keep) {
  DecisionOptions options;
  leanTowards(keep, options);
  options.check();
  return options;
}

/// How many of all bodies of evidence on ten cells are taken for moving.
int moversAmongAllEvidence(Keep keep) {
  const DecisionOptions options = optionsOf(keep);
  int movers = 0;
  for (int free = 0; free <= 10; ++free)
    for (int hit = 0; free + hit <= 10; ++hit)
      for (int glimpsed = free; glimpsed <= 10; ++glimpsed)
        for (const MotionClass motion :
             {MotionClass::Static, MotionClass::Doubtful, MotionClass::Weak}) {
          FreeSpaceSum sum;
          sum.cells = 10, sum.free = free, sum.hit = hit, sum.glimpsed = glimpsed;
          movers += isDynamic(fuseTrace(motion, sum, {}, options));
        }
  return movers;
}

TEST(KeepChoice, TheMoreIsToBeRemovedTheMoreEvidenceSuffices) {
  EXPECT_LT(moversAmongAllEvidence(Keep::Static), moversAmongAllEvidence(Keep::Balanced));
  EXPECT_LT(moversAmongAllEvidence(Keep::Balanced), moversAmongAllEvidence(Keep::Remove));
}

TEST(KeepChoice, BalancedIsTheDefault) {
  EXPECT_EQ(DecisionOptions().freeShare, optionsOf(Keep::Balanced).freeShare);
}

TEST(KeepChoice, NamesAreThoseOfTheSwitch) {
  EXPECT_EQ(Keep::Static, keepFromName("static"));
  EXPECT_EQ(Keep::Remove, keepFromName("remove"));
  EXPECT_THROW(keepFromName("all"), UserError);
}

}  // namespace
}  // namespace toss
