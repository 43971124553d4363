// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <toss/voting/FusedDecision.h>

namespace toss {
namespace {

FreeSpaceSum evidence(int cells, int free, int hit, int glimpsed) {
  FreeSpaceSum sum;
  sum.cells = cells, sum.free = free, sum.hit = hit, sum.glimpsed = glimpsed;
  return sum;
}

MotionClass fuse(MotionClass motion, const FreeSpaceSum& sum) {
  return fuseTrace(motion, sum, {}, DecisionOptions());
}

TEST(FusedDecision, WhatIsSeenThroughMovesWhateverItsTraceDid) {
  EXPECT_EQ(MotionClass::Strong, fuse(MotionClass::Static, evidence(10, 5, 2, 5)));
}

TEST(FusedDecision, WhatIsMeasuredAgainStaysHoweverItsTraceMoved) {
  EXPECT_EQ(MotionClass::Static, fuse(MotionClass::Strong, evidence(10, 0, 8, 0)));
}

TEST(FusedDecision, WhatIsMeasuredAgainWhereItWasFastSlidesAlong) {
  const DecisionOptions options;
  const auto fused = [&](const FreeSpaceSum& all, const FreeSpaceSum& whileFast) {
    return fuseTrace(MotionClass::Strong, all, whileFast, options);
  };
  const FreeSpaceSum parkedFirst = evidence(40, 3, 30, 5);
  EXPECT_EQ(MotionClass::Static, fused(parkedFirst, evidence(20, 2, 16, 3)));
  EXPECT_EQ(MotionClass::Strong, fused(parkedFirst, evidence(20, 3, 8, 3)));
  EXPECT_EQ(MotionClass::Strong, fused(parkedFirst, evidence(20, 4, 16, 3)));
  EXPECT_EQ(MotionClass::Strong, fused(parkedFirst, {}));
  EXPECT_EQ(MotionClass::Strong, fused(evidence(40, 15, 20, 15), evidence(20, 2, 16, 3)));
}

TEST(FusedDecision, DoubtfulMotionNeedsGlimpsesPastIt) {
  EXPECT_EQ(MotionClass::Static, fuse(MotionClass::Doubtful, evidence(10, 0, 1, 0)));
  EXPECT_EQ(MotionClass::Static, fuse(MotionClass::Doubtful, evidence(20, 0, 2, 3)));
  EXPECT_EQ(MotionClass::Strong, fuse(MotionClass::Doubtful, evidence(10, 0, 1, 4)));
}

TEST(FusedDecision, GlimpsesAloneMoveNothing) {
  EXPECT_EQ(MotionClass::Static, fuse(MotionClass::Static, evidence(10, 0, 1, 9)));
}

TEST(FusedDecision, DoubtfulIsNotDynamic) {
  EXPECT_FALSE(isDynamic(MotionClass::Doubtful));
  EXPECT_TRUE(isDynamic(MotionClass::Weak));
}

}  // namespace
}  // namespace toss
