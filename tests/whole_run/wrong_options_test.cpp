// SPDX-License-Identifier: BSD-3-Clause
#include "CrossingLog.h"

namespace toss::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

class WrongOptions : public CrossingLog {
 protected:
  /// Maps with `options`, which are wrong: one line, and nothing is left behind.
  static std::string complaint(const std::string& options) {
    const std::string line =
        complaintOf("map " + quoted(rawlog()) + " --out " + quoted(in("none")) + " " + options);
    EXPECT_TRUE(filesIn(in("none")).empty());
    return line;
  }
  static std::string configComplaint(const std::string& text) {
    writeBytes(in("wrong.ini"), text);
    return complaint("--config " + quoted(in("wrong.ini")));
  }
};

TEST_F(WrongOptions, UnknownSectionsAndKeysNameTheNearest) {
  EXPECT_THAT(complaint("--set vting.tau=2"), HasSubstr("did you mean 'voting'?"));
  EXPECT_THAT(complaint("--set voting.tua_d=2"), HasSubstr("did you mean 'tau_d'?"));
  EXPECT_THAT(complaint("--set voting"), HasSubstr("voting"));
}

TEST_F(WrongOptions, ValuesOutOfRangeNameTheirBounds) {
  EXPECT_THAT(complaint("--set voting.tau=-2"), AllOf(HasSubstr("'-2'"), HasSubstr("from 0.01")));
  EXPECT_THAT(complaint("--set map.voxel_size=ten"), AllOf(HasSubstr("'ten'"), HasSubstr("from ")));
  EXPECT_THAT(complaint("--set map.voxel_size=nan"), HasSubstr("from "));
  EXPECT_THAT(complaint("--set voting.mode=loud"), HasSubstr("loud"));
}

TEST_F(WrongOptions, ValuesThatContradictEachOtherAreRefused) {
  EXPECT_THAT(complaint("--set voting.tau_d=3 --set voting.tau_s=1"), HasSubstr("tau_s"));
}

TEST_F(WrongOptions, WhatToKeepIsOneOfThree) {
  EXPECT_THAT(complaint("--keep all"),
              AllOf(HasSubstr("--keep all"), HasSubstr("static, balanced or remove")));
}

TEST_F(WrongOptions, ConfigurationFilesAreCheckedAlike) {
  EXPECT_THAT(configComplaint("[votin]\ntau = 1\n"),
              AllOf(HasSubstr("wrong.ini"), HasSubstr("did you mean 'voting'?")));
  EXPECT_THAT(configComplaint("[voting]\ntaus = 1\n"),
              AllOf(HasSubstr("wrong.ini"), HasSubstr("did you mean 'tau")));
  EXPECT_THAT(configComplaint("[voting]\ntau = 1e9\n"),
              AllOf(HasSubstr("wrong.ini"), HasSubstr("from 0.01")));
  EXPECT_THAT(complaint("--config " + quoted(in("absent.ini"))), HasSubstr("absent.ini"));
}

TEST_F(WrongOptions, UnknownSensorsNameTheNearest) {
  EXPECT_THAT(complaint("--set sensor.model=VLP16"), HasSubstr("did you mean 'VLP-16'?"));
}

TEST_F(WrongOptions, RangesWithoutAScanAreRefused) {
  EXPECT_THAT(complaint("--from 30"), HasSubstr("range"));
  EXPECT_THAT(complaint("--from 30 --set sensor.model=VLP-16"), HasSubstr("range"));
  EXPECT_THAT(complaint("--from 9 --to 8"), AllOf(HasSubstr("--from 9"), HasSubstr("--to 8")));
}

}  // namespace
}  // namespace toss::test
