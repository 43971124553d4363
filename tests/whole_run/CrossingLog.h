// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "Program.h"

namespace toss::test {

/// The simulated crossing (a car crosses, a person walks; a parked car, walls), as a rawlog and as
/// a KITTI folder, and a run of it; made once for all tests of a suite.
class CrossingLog : public ::testing::Test {
 protected:
  static constexpr std::uint64_t kScans = 30;

  static void SetUpTestSuite() {
    folder_ = std::make_unique<TemporaryFolder>();
    runWell("simulate crossing " + quoted(rawlog()));
  }
  static void TearDownTestSuite() { folder_.reset(); }

  static fs::path in(const std::string& name) { return *folder_ / name; }
  static fs::path rawlog() { return in("crossing.rawlog"); }

  /// Maps `input` into `name`, which is made anew.
  static fs::path map(const fs::path& input, const std::string& name,
                      const std::string& options = "--no-snapshots") {
    fs::remove_all(in(name));
    runWell("map " + quoted(input) + " --out " + quoted(in(name)) + " " + options);
    return in(name);
  }
  /// The run that most tests look at; made when it is first asked for.
  static fs::path run() { return fs::exists(in("run")) ? in("run") : map(rawlog(), "run", ""); }

 private:
  static inline std::unique_ptr<TemporaryFolder> folder_;
};

}  // namespace toss::test
