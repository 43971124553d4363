// SPDX-License-Identifier: BSD-3-Clause
// The plug-in is neither linked nor known by name here: all goes through classes of MRPT.
#include <mrpt/config/CConfigFile.h>
#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/maps/CMultiMetricMap.h>
#include <mrpt/system/os.h>

#include "CrossingLog.h"

namespace toss::test {
namespace {

class LoadedModule : public CrossingLog {
 protected:
  void SetUp() override {
    std::string error;
    ASSERT_TRUE(mrpt::system::loadPluginModule(TOSS_PLUG_IN, error)) << error;
  }

  static mrpt::maps::CMultiMetricMap mapsOf(const mrpt::config::CConfigFileBase& ini) {
    mrpt::maps::TSetOfMetricMapInitializers definitions;
    definitions.loadFromConfigFile(ini, "map");
    return mrpt::maps::CMultiMetricMap(definitions);
  }
  static mrpt::maps::CMultiMetricMap mapsOf(const std::string& section, const std::string& keys) {
    mrpt::config::CConfigFileMemory ini;
    ini.setContent("[map]\ndynamicFilteredPointsMap_count = 1\n[" + section + "]\n" + keys);
    return mapsOf(ini);
  }
  static std::string complaintAbout(const std::string& section, const std::string& keys) {
    return userErrorOf([&] { mapsOf("map_dynamicFilteredPointsMap_00_" + section, keys); });
  }

  /// The whole log, observation by observation, with the pose that comes before each.
  static void insertLog(mrpt::maps::CMultiMetricMap& maps) {
    mrpt::io::CFileGZInputStream stream(rawlog().string());
    auto archive = mrpt::serialization::archiveFrom(stream);
    mrpt::poses::CPose3D pose;
    try {
      for (;;) {
        const auto object = archive.ReadObject<mrpt::obs::CObservation>();
        if (const auto* posed = dynamic_cast<const mrpt::obs::CObservationRobotPose*>(object.get()))
          pose = posed->pose.mean;
        else
          EXPECT_TRUE(maps.insertObservation(*object, pose));
      }
    } catch (const mrpt::serialization::CExceptionEOF&) {
    }
  }

  /// What toss map makes of the scans as they lie in the log: the plug-in gets one pose per scan,
  /// and can't tell how the sensor moved during it.
  static fs::path asRecorded() {
    return fs::exists(in("as_recorded"))
               ? in("as_recorded")
               : map(rawlog(), "as_recorded", "--no-snapshots --set input.deskew=off");
  }

  static std::string mapFileOf(const std::string& prefix) {
    for (const auto& [name, bytes] : filesIn(in("")))
      if (name.rfind(prefix, 0) == 0 && fs::path(name).extension() == ".ply") return bytes;
    return "";
  }
};

TEST_F(LoadedModule, MakesTheMapThatTossMapWrites) {
  mrpt::maps::CMultiMetricMap maps = mapsOf(mrpt::config::CConfigFile(TOSS_EXAMPLE_INI));
  ASSERT_EQ(maps.maps.size(), 1u);
  EXPECT_TRUE(maps.isEmpty());
  insertLog(maps);
  EXPECT_FALSE(maps.isEmpty());
  maps.saveMetricMapRepresentationToFile(in("saved").string());
  const std::string expected = readBytes(asRecorded() / "static_map.ply");
  ASSERT_GT(expected.size(), 1000u);
  EXPECT_TRUE(mapFileOf("saved") == expected);
}

TEST_F(LoadedModule, TakesOptionsAndConfigurationsAsTossMapDoes) {
  const std::string keys = "config = " + (asRecorded() / "config.ini").string() +
                           "\nplugin.rawlog = " + rawlog().string() +
                           "\nmap.voxel_size = 0.5\nsensor.model = HDL-64E\n";
  mrpt::maps::CMultiMetricMap maps = mapsOf("map_dynamicFilteredPointsMap_00_insertOpts", keys);
  insertLog(maps);
  maps.saveMetricMapRepresentationToFile(in("coarse").string());
  const fs::path same = map(rawlog(), "same",
                            "--no-snapshots --config " + quoted(asRecorded() / "config.ini") +
                                " --set map.voxel_size=0.5 --set sensor.model=HDL-64E");
  EXPECT_TRUE(mapFileOf("coarse") == readBytes(same / "static_map.ply"));
}

TEST_F(LoadedModule, IsUsedByTheExampleProgram) {
  const std::string command = quoted(TOSS_EXAMPLE_PROGRAM) + " " + quoted(TOSS_PLUG_IN) + " " +
                              quoted(TOSS_EXAMPLE_INI) + " " + quoted(rawlog()) + " " +
                              quoted(in("example"));
  ASSERT_EQ(std::system(command.c_str()), 0);
  EXPECT_TRUE(mapFileOf("example") == readBytes(asRecorded() / "static_map.ply"));
}

TEST_F(LoadedModule, NamesTheNearestKeyForOneThatIsUnknown) {
  EXPECT_THAT(complaintAbout("insertOpts", "map.voxelsize = 0.2\n"),
              ::testing::AllOf(::testing::HasSubstr("map.voxelsize"),
                               ::testing::HasSubstr("did you mean 'voxel_size'")));
  EXPECT_THAT(complaintAbout("insertOpts", "grund.extent = 40\n"),
              ::testing::HasSubstr("did you mean 'ground'"));
  EXPECT_THAT(complaintAbout("insertOpts", "voxel_size = 40\n"),
              ::testing::HasSubstr("section.key=value"));
  EXPECT_THAT(complaintAbout("likelihoodOpts", "sigma_dst = 1\n"),
              ::testing::HasSubstr("did you mean 'sigma_dist'"));
  EXPECT_THAT(complaintAbout("creationOpts", "enableInsertion = 1\n"),
              ::testing::HasSubstr("enableObservationInsertion"));
  EXPECT_THAT(complaintAbout("insertionOpts", "map.voxel_size = 0.2\n"),
              ::testing::HasSubstr("_insertOpts"));
}

TEST_F(LoadedModule, RefusesValuesOutOfRangeInOneLine) {
  const std::string complaint = complaintAbout("insertOpts", "map.voxel_size = -1\n");
  EXPECT_THAT(complaint, ::testing::HasSubstr("voxel_size"));
  EXPECT_EQ(complaint.find('\n'), std::string::npos);
  EXPECT_THAT(complaintAbout("insertOpts", "config = /nowhere/x.ini\n"),
              ::testing::HasSubstr("can not be read"));
}

TEST_F(LoadedModule, IsLoadedByRawlogEdit) {
  if (std::system("command -v rawlog-edit >/dev/null") != 0)
    GTEST_SKIP() << "rawlog-edit is not installed (package mrpt-apps)";
  const std::string command = "rawlog-edit -p " + quoted(TOSS_PLUG_IN) + " --info -i " +
                              quoted(rawlog()) + " >" + quoted(in("said")) + " 2>&1";
  ASSERT_EQ(std::system(command.c_str()), 0);
  EXPECT_THAT(readBytes(in("said")), ::testing::HasSubstr("VLP-16"));
}

TEST_F(LoadedModule, SurvivesBeingUnloaded) {
  mrpt::maps::CMultiMetricMap maps = mapsOf(mrpt::config::CConfigFile(TOSS_EXAMPLE_INI));
  std::string error;
  ASSERT_TRUE(mrpt::system::unloadPluginModule(TOSS_PLUG_IN, error)) << error;
  EXPECT_EQ(mapsOf(mrpt::config::CConfigFile(TOSS_EXAMPLE_INI)).maps.size(), 1u);
  EXPECT_TRUE(maps.isEmpty());
}

}  // namespace
}  // namespace toss::test
