// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <toss/evaluation/ClassOracle.h>
#include <toss/evaluation/LossCauses.h>
#include <toss/rawlog/LabelFile.h>

#include <set>
#include <string>

namespace toss::test {
namespace {

TEST(ReturnFacts, ComeBackFromALabel) {
  std::set<std::uint32_t> seen;
  for (int band = 0; band < kRangeBands; ++band) {
    for (int returns = 0; returns < kReturnSteps; ++returns) {
      for (int cause = 0; cause < kLossCauses; ++cause) {
        const auto packed = packFacts(259, {band, returns, static_cast<LossCause>(cause)});
        const ReturnFacts facts = unpackFacts(packed);
        EXPECT_EQ(facts.band, band);
        EXPECT_EQ(facts.returns, returns);
        EXPECT_EQ(static_cast<int>(facts.cause), cause);
        EXPECT_EQ(label::semantic(packed), 259u);
        seen.insert(packed);
      }
    }
  }
  EXPECT_EQ(seen.size(), static_cast<std::size_t>(kRangeBands * kReturnSteps * kLossCauses));
}

TEST(ReturnFacts, DropTheInstanceOfTheTrueLabel) {
  EXPECT_EQ(packFacts(0xABCD0000u | 252u, {}), 252u);
}

TEST(ReturnStep, CutsAtTheSizesOfTheBounds) {
  EXPECT_EQ(returnStep(2), 0);
  EXPECT_EQ(returnStep(3), 1);
  EXPECT_EQ(returnStep(5), 2);
  EXPECT_EQ(returnStep(9), 2);
  EXPECT_EQ(returnStep(10), 3);
  EXPECT_EQ(returnStep(50), 4);
}

TEST(LossNames, AreAllDifferent) {
  std::set<std::string> names;
  for (int c = 0; c < kLossCauses; ++c) names.insert(lossCauseName(static_cast<LossCause>(c)));
  EXPECT_EQ(names.size(), static_cast<std::size_t>(kLossCauses));
}

TEST(LossTable, CountsVoxelsWhereTheyBelong) {
  LabelledCloud truth, estimate;
  truth.add(0, 0, 0, packFacts(9, {0, 0, {}}));
  truth.add(1, 0, 0, packFacts(9, {2, 0, {}}));
  truth.add(2, 0, 0, packFacts(252, {1, 3, LossCause::Ground}));
  truth.add(3, 0, 0, packFacts(252, {1, 4, LossCause::Ground}));
  estimate.add(0, 0, 0, packFacts(9, {}));
  // The cause is that of the return which the estimate has there.
  estimate.add(3, 0, 0, packFacts(252, {1, 4, LossCause::Merged}));
  const LossTable table = lossTable(truth, estimate, compareMaps(truth, estimate, 0.2));
  EXPECT_EQ(table.staticByRange[0].right, 1u);
  EXPECT_EQ(table.staticByRange[2].voxels, 1u);
  EXPECT_EQ(table.staticByRange[2].right, 0u);
  EXPECT_EQ(table.movingByRange[1].voxels, 2u);
  EXPECT_EQ(table.movingByRange[1].right, 1u);
  EXPECT_EQ(table.movingByReturns[3].right, 1u);
  EXPECT_EQ(table.movingByReturns[4].right, 0u);
  EXPECT_EQ(table.residueByCause[static_cast<std::size_t>(LossCause::Merged)], 1u);
  EXPECT_EQ(table.residueByCause[static_cast<std::size_t>(LossCause::Ground)], 0u);
}

TEST(ClassOracle, DecidesByMajority) {
  const auto inGroup = [](std::uint32_t group) { return group << 16; };
  ClassOracle oracle;
  oracle.add({252, 252, 9, 252, 9, 252},
             {inGroup(1), inGroup(1), inGroup(1), inGroup(2), inGroup(2), inGroup(0)}, false);
  EXPECT_TRUE(oracle.moving(1));
  EXPECT_FALSE(oracle.moving(2));  // a tie stands still
  EXPECT_FALSE(oracle.moving(0));  // no group
  EXPECT_FALSE(oracle.moving(3));
  oracle.clear();
  EXPECT_FALSE(oracle.moving(1));
}

TEST(ClassOracle, LeavesOutWhatIsNotAnnotated) {
  const std::vector<std::uint32_t> truth = {252, 0, 0}, groups(3, 5u << 16);
  ClassOracle annotated, all;
  annotated.add(truth, groups, true);
  all.add(truth, groups, false);
  EXPECT_TRUE(annotated.moving(5));
  EXPECT_FALSE(all.moving(5));
}

}  // namespace
}  // namespace toss::test
