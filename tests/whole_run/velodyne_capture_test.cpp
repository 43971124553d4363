// SPDX-License-Identifier: BSD-3-Clause
// Captures of real Velodyne sensors, imported and mapped.
#include <mrpt/obs/CObservationVelodyneScan.h>
#include <mrpt/obs/CRawlog.h>

#include "Program.h"

namespace toss::test {
namespace {

using ::testing::HasSubstr;

struct Capture {
  const char *file, *model;
  /// Fewest points of the map: a small room, and a street.
  std::size_t mapPoints;
};

class VelodyneCapture : public ::testing::TestWithParam<Capture> {
 protected:
  void SetUp() override {
    const fs::path capture = dataFolder() / "velodyne" / GetParam().file;
    if (dataFolder().empty() || !fs::exists(capture)) GTEST_SKIP() << "no real data";
    runWell("import velodyne " + quoted(capture) + " " + quoted(log) + " --model " +
            GetParam().model);
  }

  /// A rawlog goes on with another behind it: the sensor stands still.
  void addPoses() const {
    mrpt::obs::CRawlog rawlog;
    rawlog.loadFromRawLogFile(log.string());
    std::vector<Object> poses;
    for (std::size_t i = 0; i < rawlog.size(); ++i)
      if (const auto scan = std::dynamic_pointer_cast<mrpt::obs::CObservationVelodyneScan>(
              rawlog.getAsGeneric(i)))
        poses.push_back(poseObservation(fromMrptTime(scan->timestamp), poseOf(0, 0, 0, 0)));
    writeObjects(folder / "poses.rawlog", poses);
    std::ofstream(log, std::ios::binary | std::ios::app) << readBytes(folder / "poses.rawlog");
  }

  TemporaryFolder folder;
  fs::path log = folder / "a.rawlog", run = folder / "run";
};

TEST_P(VelodyneCapture, NeedsPosesAndIsMappedWithThem) {
  const std::string map = "map " + quoted(log) + " --no-snapshots --out " + quoted(run);
  EXPECT_THAT(complaintOf(map),
              ::testing::AllOf(HasSubstr("holds no poses of the robot"), HasSubstr("--poses FILE"),
                               HasSubstr("--odometry")));
  addPoses();
  runWell(map);
  const std::string ply = readBytes(run / "static_map.ply");
  const std::string mark = "element vertex ";
  EXPECT_GE(std::stoul(ply.substr(ply.find(mark) + mark.size())), GetParam().mapPoints);
  EXPECT_THAT(readBytes(run / "summary.json"), HasSubstr("\"skipped_for_pose\": 0"));
}

INSTANTIATE_TEST_SUITE_P(Sensors, VelodyneCapture,
                         ::testing::Values(Capture{"sample_velodyne_vlp16_gps.pcap", "VLP16", 800},
                                           Capture{"sample_velodyne_hdl32.pcap", "HDL32", 30000}));

}  // namespace
}  // namespace toss::test
