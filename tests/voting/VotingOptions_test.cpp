// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <toss/voting/DsVoting.h>

namespace toss {
namespace {

TEST(VotingOptions, DefaultsArePermitted) {
  EXPECT_NO_THROW(DsVoting{VotingOptions{}});
}

TEST(VotingOptions, WindowsMustNotTouch) {
  VotingOptions options;
  options.tauS = options.tauD = 1.0;
  EXPECT_THROW(DsVoting{options}, UserError);
}

TEST(VotingOptions, TauRangeMustNotBeEmpty) {
  VotingOptions options;
  options.tauMin = 2.0;
  EXPECT_THROW(DsVoting{options}, UserError);
}

TEST(VotingOptions, HorizonMustHoldTheDistantWindow) {
  VotingOptions options;
  options.horizon = 1.0;
  EXPECT_THROW(DsVoting{options}, UserError);
  options.horizon = 0.0;
  EXPECT_NO_THROW(DsVoting{options});
}

TEST(VotingOptions, ModesAreReadByName) {
  VotingOptions options;
  options.set("mode", "dynamic_only");
  EXPECT_EQ(options.mode, VotingMode::DynamicOnly);
  EXPECT_THROW(options.set("mode", "guardet"), UserError);
  EXPECT_THROW(options.set("tau_d", "-1"), UserError);
}

}  // namespace
}  // namespace toss
