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
  return fuseTrace(motion, sum, DecisionOptions());
}

TEST(FusedDecision, WhatIsSeenThroughMovesWhateverItsTraceDid) {
  EXPECT_EQ(MotionClass::Strong, fuse(MotionClass::Static, evidence(10, 5, 2, 5)));
}

TEST(FusedDecision, WhatIsMeasuredAgainStaysHoweverItsTraceMoved) {
  EXPECT_EQ(MotionClass::Static, fuse(MotionClass::Strong, evidence(10, 0, 8, 0)));
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
