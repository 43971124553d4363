// SPDX-License-Identifier: BSD-3-Clause
// Each silent failure of a log, put into a log that is fit.
#include <toss/rawlog/PoseFile.h>
#include <toss/rawlog/RawlogWriter.h>
#include <toss/simulation/Simulator.h>

#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>

#include "Program.h"

namespace toss::test {
namespace {

using ::testing::HasSubstr;

/// Scans of a car that brakes at a junction, kept in memory; faults are put into copies.
class Check : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    SimulationOptions options;
    options.scene = "junction";
    options.sensor = "VLP-16";
    scans_ = drive(options);
  }
  static void TearDownTestSuite() { scans_.clear(); }

  /// Keys and severities of what is found once `change` has been at each scan; no-times, which all
  /// logs here have, goes to distortion_.
  nlohmann::json findings(const std::function<void(std::size_t, PosedScan&)>& change = {},
                          const std::string& options = "") {
    return findingsIn(rawlogOf(scans_, change), options);
  }
  nlohmann::json findingsIn(const fs::path& input, const std::string& options = "") {
    const fs::path json = folder_ / "found.json";
    run_ = runProgram("check " + quoted(input) + " --json " + quoted(json) + " " + options);
    const auto parsed = nlohmann::json::parse(readBytes(json));
    EXPECT_EQ(run_.code, parsed["fit"].get<bool>() ? 0 : 1);
    distortion_ = readBytes(json).find("no-times") != std::string::npos;
    nlohmann::json found = nlohmann::json::object();
    for (const auto& finding : parsed["findings"]) {
      if (finding["key"] != "no-times")
        found[finding["key"].get<std::string>()] = finding["severity"];
      EXPECT_THAT(run_.out, HasSubstr(finding["key"].get<std::string>()));
    }
    return found;
  }
  fs::path rawlogOf(std::vector<PosedScan> scans,
                    const std::function<void(std::size_t, PosedScan&)>& change = {}) {
    RawlogWriter writer(folder_ / "a.rawlog");
    for (std::size_t i = 0; i < scans.size(); ++i) {
      if (change) change(i, scans[i]);
      writer.write(scans[i]);
    }
    writer.commit();
    return folder_ / "a.rawlog";
  }
  static std::vector<PosedScan> drive(const SimulationOptions& options) {
    Simulator simulator(options);
    SimulatedScan scan;
    std::vector<PosedScan> scans;
    while (scans.size() < 50 && simulator.next(scan)) {
      scan.scan.points.ring.clear(), scan.scan.points.time.clear();
      scans.push_back(scan.scan);
    }
    return scans;
  }

  static inline std::vector<PosedScan> scans_;
  TemporaryFolder folder_;
  ProgramRun run_;
  bool distortion_ = false;
};

TEST_F(Check, FindsNoFaultWhereThereIsNone) {
  const nlohmann::json found = findings();
  EXPECT_EQ(run_.code, 0);
  EXPECT_THAT(run_.out, HasSubstr("fit to be mapped"));
  EXPECT_THAT(run_.out, HasSubstr("VLP-16"));
  EXPECT_TRUE(found.empty()) << found;
}

TEST_F(Check, FindsPosesThatStandStill) {
  EXPECT_EQ(findings([](std::size_t, PosedScan& s) { s.mapFromSensor.setIdentity(); }),
            (nlohmann::json{{"poses-still", "fault"}}));
  EXPECT_THAT(run_.error, HasSubstr("unfit"));
}

TEST_F(Check, FindsInvertedPoses) {
  EXPECT_EQ(
      findings([](std::size_t, PosedScan& s) { s.mapFromSensor = s.mapFromSensor.inverse(); }),
      (nlohmann::json{{"poses-inverted", "fault"}}));
}

TEST_F(Check, FindsPosesOfTheCamera) {
  Eigen::Isometry3d camera = Eigen::Isometry3d::Identity();
  camera.linear() << 0, -1, 0, 0, 0, -1, 1, 0, 0;
  camera.translation() << 0.02, -0.06, -0.33;
  EXPECT_EQ(findings([&](std::size_t, PosedScan& s) {
              s.mapFromSensor = camera * s.mapFromSensor * camera.inverse();
            }),
            (nlohmann::json{{"pose-camera", "fault"}}));
  EXPECT_THAT(run_.out, HasSubstr("calib.txt"));
}

TEST_F(Check, FindsAForgottenPoseOfTheSensor) {
  const Eigen::Isometry3d robotFromSensor = poseOf(0, 0, 0, 2.0);
  EXPECT_EQ(findings([&](std::size_t, PosedScan& s) {
              s.mapFromSensor = s.mapFromSensor * robotFromSensor.inverse();
            }),
            (nlohmann::json{{"pose-frame", "fault"}}));
  EXPECT_THAT(run_.out, HasSubstr("yaw 11"));
}

TEST_F(Check, FindsPosesInAnotherUnit) {
  EXPECT_EQ(findings([](std::size_t, PosedScan& s) { s.mapFromSensor.translation() *= 1000.0; }),
            (nlohmann::json{{"pose-scale", "fault"}}));
}

TEST_F(Check, FindsAnotherClock) {
  std::vector<double> times;
  std::vector<Eigen::Isometry3d> poses;
  for (const PosedScan& scan : scans_)
    times.push_back(scan.time + 0.4), poses.push_back(scan.mapFromSensor);
  writePoseFile(folder_ / "poses.txt", PoseFileFormat::Tum, times, poses);
  const std::string options = "--poses " + quoted(folder_ / "poses.txt");
  EXPECT_EQ(findingsIn(rawlogOf(scans_), options).value("pose-time", ""), "fault") << run_.out;
  EXPECT_THAT(run_.out, HasSubstr("input.time_offset to its present value plus 0.4"));
  findingsIn(rawlogOf(scans_), options + " --set input.time_offset=0.4");
  EXPECT_EQ(run_.code, 0) << run_.out;
}

TEST_F(Check, FindsPosesThatHaveNothingToDoWithTheScans) {
  EXPECT_EQ(findings([](std::size_t i, PosedScan& s) {
              const double t = static_cast<double>(i);
              s.mapFromSensor = poseOf(5 * std::sin(t), 4 * std::cos(2.3 * t), 0, std::sin(t * t));
            }),
            (nlohmann::json{{"poses-wrong", "fault"}}));
}

TEST_F(Check, FindsReturnsAtTheOriginAndThoseThatAreNotFinite) {
  EXPECT_EQ(findings([](std::size_t, PosedScan& s) {
              s.points.x[10] = s.points.y[10] = s.points.z[10] = 0.0f;
              s.points.y[20] = std::nanf("");
            }),
            (nlohmann::json{{"origin-returns", "note"}, {"not-finite", "note"}}));
  EXPECT_EQ(run_.code, 0);
}

TEST_F(Check, FindsGapsAndScansOutOfOrder) {
  EXPECT_EQ(findings([](std::size_t i, PosedScan& s) { s.time += i < 30 ? 0.0 : 3.0; }),
            (nlohmann::json{{"time-gaps", "doubt"}}));
  const nlohmann::json found =
      findings([](std::size_t i, PosedScan& s) { s.time -= i % 3 == 2 ? 0.15 : 0.0; });
  EXPECT_EQ(found.value("scans-lost", ""), "fault");
  EXPECT_THAT(run_.out, HasSubstr("not later than the one before"));
}

TEST_F(Check, FindsScansWithoutPoses) {
  std::vector<Object> objects;
  for (std::size_t i = 0; i < 20; ++i)
    objects.push_back(cloudObservation(scans_[i].time, scans_[i]));
  writeObjects(folder_ / "bare.rawlog", objects);
  EXPECT_EQ(findingsIn(folder_ / "bare.rawlog"), (nlohmann::json{{"unreadable", "fault"}}));
  EXPECT_THAT(run_.out, HasSubstr("--odometry"));
  std::vector<double> times;
  std::vector<Eigen::Isometry3d> poses;
  for (std::size_t i = 0; i < 20; ++i)
    times.push_back(scans_[i].time), poses.push_back(scans_[i].mapFromSensor);
  writePoseFile(folder_ / "poses.txt", PoseFileFormat::Tum, times, poses);
  findingsIn(folder_ / "bare.rawlog", "--poses " + quoted(folder_ / "poses.txt"));
  EXPECT_EQ(run_.code, 0) << run_.out;
}

TEST_F(Check, FindsASensorThatItDoesNotKnow) {
  EXPECT_EQ(findings([](std::size_t, PosedScan& s) {
              s.sensorLabel = "front";
              for (std::size_t p = 0; p < s.points.size(); ++p)
                s.points.z[p] = 2.0f * std::hypot(s.points.x[p], s.points.y[p]);
            }).value("sensor", ""),
            "doubt");
}

TEST_F(Check, TellsHowFarSweepsWithoutTimesMayBeDistorted) {
  findings();
  EXPECT_TRUE(distortion_);
  std::vector<PosedScan> timed = scans_;
  for (PosedScan& each : timed) {
    each.points.ring.assign(each.points.size(), 0);
    each.points.time.assign(each.points.size(), 0.0f);
    each.motionCompensated = true;
  }
  findingsIn(rawlogOf(timed));
  EXPECT_FALSE(distortion_);
}

TEST_F(Check, FindsACalibrationThatIsForgotten) {
  const fs::path data = dataFolder() / "kitti-tracking-0000";
  if (dataFolder().empty()) GTEST_SKIP() << "real data is absent, set TOSS_TEST_DATA";
  const fs::path folder = folder_ / "kitti";
  fs::create_directories(folder);
  fs::create_directory_symlink(data / "velodyne", folder / "velodyne");
  fs::copy(data / "times.txt", folder / "times.txt");
  fs::copy(data / "poses.txt", folder / "poses.txt");
  EXPECT_EQ(findingsIn(folder, "--to 30").value("pose-camera", ""), "fault") << run_.out;
  fs::copy(data / "calib.txt", folder / "calib.txt");
  findingsIn(folder, "--to 30");
  EXPECT_EQ(run_.code, 0) << run_.out;
}

}  // namespace
}  // namespace toss::test
