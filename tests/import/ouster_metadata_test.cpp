// SPDX-License-Identifier: BSD-3-Clause
#include <InputFixtures.h>
#include <toss/import/OusterMetadata.h>

#include "OusterFixtures.h"

namespace toss::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr double kDegree = 3.14159265358979323846 / 180.0;

class OusterMetadataFile : public ::testing::Test {
 protected:
  OusterMetadata read(const nlohmann::json& json) { return readText(json.dump()); }
  OusterMetadata readText(const std::string& text) {
    writeBytes(folder / "meta.json", text);
    return readOusterMetadata(folder / "meta.json");
  }
  std::string errorOf(const nlohmann::json& json) {
    return userErrorOf([&] { read(json); });
  }

  TemporaryFolder folder;
  FakeOuster sensor;
};

TEST_F(OusterMetadataFile, ReadsBothLayoutsAlike) {
  for (const nlohmann::json& json : {sensor.flatMetadata(), sensor.sectionedMetadata()}) {
    const OusterMetadata metadata = read(json);
    EXPECT_EQ(metadata.productLine, "OS-1-8");
    EXPECT_EQ(metadata.serialNumber, 122201000998u);
    EXPECT_EQ(metadata.initializationId, 7109750u);
    EXPECT_EQ(metadata.lidarPort, 7502);
    EXPECT_EQ(metadata.profile, OusterProfile::Rng19Rfl8Sig16Nir16);
    EXPECT_EQ(metadata.pixelsPerColumn, 8);
    EXPECT_EQ(metadata.columnsPerPacket, 16);
    EXPECT_EQ(metadata.columnsPerFrame, 512);
    EXPECT_EQ(metadata.columnsInWindow(), 512);
    EXPECT_EQ(metadata.fullReflectivity, 255.0);
    EXPECT_NEAR(metadata.beamAltitudes.at(0), 15.0 * kDegree, 1e-12);
    EXPECT_NEAR(metadata.beamAzimuths.at(1), 1.0 * kDegree, 1e-12);
    EXPECT_NEAR(metadata.beamOriginForward, 0.015806, 1e-12);
    EXPECT_NEAR(metadata.sensorFromLidar.translation().z(), 0.03618, 1e-12);
    EXPECT_EQ(metadata.sensorFromLidar.linear()(0, 0), -1.0);
    EXPECT_THAT(metadata.notes, IsEmpty());
  }
}

TEST_F(OusterMetadataFile, TakesWhatIsMissingFromTheDataSheets) {
  nlohmann::json json = sensor.flatMetadata();
  for (const char* name : {"lidar_origin_to_beam_origin_mm", "lidar_to_sensor_transform"})
    json.erase(name);
  const OusterMetadata metadata = read(json);
  EXPECT_NEAR(metadata.beamOriginForward, 0.015806, 1e-12);
  EXPECT_NEAR(metadata.sensorFromLidar.translation().z(), 0.03618, 1e-12);
  EXPECT_EQ(metadata.notes.size(), 2u);
}

TEST_F(OusterMetadataFile, KnowsWindowsAndBeamOriginsAboveTheLidar) {
  nlohmann::json json = sensor.flatMetadata();
  json["data_format"]["column_window"] = {500, 20};
  json["beam_to_lidar_transform"] = {1, 0, 0, 13.762, 0, 1, 0, 0, 0, 0, 1, 2.5, 0, 0, 0, 1};
  const OusterMetadata metadata = read(json);
  EXPECT_EQ(metadata.columnsInWindow(), 33);
  EXPECT_TRUE(metadata.inWindow(511));
  EXPECT_TRUE(metadata.inWindow(20));
  EXPECT_FALSE(metadata.inWindow(21));
  EXPECT_NEAR(metadata.beamOriginForward, 0.013762, 1e-12);
  EXPECT_NEAR(metadata.beamOriginUp, 0.0025, 1e-12);
}

TEST_F(OusterMetadataFile, TellsCalibratedReflectivityByTheFirmware) {
  sensor.profile = OusterProfile::Legacy;
  nlohmann::json json = sensor.flatMetadata();
  for (const auto& [revision, full] :
       std::vector<std::pair<std::string, double>>{{"v1.13.0", 65535.0},
                                                   {"v2.0.0", 65535.0},
                                                   {"v2.1.2", 255.0},
                                                   {"v3.0.1", 255.0},
                                                   {"", 65535.0},
                                                   {"dev", 65535.0}}) {
    json["build_rev"] = revision;
    EXPECT_EQ(read(json).fullReflectivity, full) << revision;
  }
}

TEST_F(OusterMetadataFile, SaysWhatIsWrong) {
  const std::vector<std::tuple<std::string, nlohmann::json, std::string>> cases = {
      {"udp_profile_lidar", "FIVE_WORD_PIXEL", "not read"},
      {"lidar_mode", "1000x10", "not known"},
      {"beam_altitude_angles", {1.0, 2.0}, "2 numbers instead of 8"},
      {"beam_altitude_angles", "none", "no list of numbers"},
      {"beam_altitude_angles", {1, 2, 3, 4, 5, 6, 7, 100}, "no beam can have"},
      {"beam_azimuth_angles", nullptr, "is missing"},
      {"pixels_per_column", 0, "is 0"},
      {"pixels_per_column", -8, "no whole number"},
      {"pixels_per_column", 100000, "greater than"},
      {"column_window", {0, 600}, "outside"},
      {"prod_sn", "SN-1", "no whole number"},
      {"lidar_to_sensor_transform", std::vector<int>(16, 0), "no rigid motion"},
      {"lidar_origin_to_beam_origin_mm", 9000.0, "outside of the sensor"},
  };
  for (const auto& [name, value, problem] : cases) {
    nlohmann::json json = sensor.flatMetadata();
    (json["data_format"].contains(name) ? json["data_format"] : json)[name] = value;
    EXPECT_THAT(errorOf(json),
                ::testing::AllOf(HasSubstr("meta.json"), HasSubstr(name), HasSubstr(problem)));
  }
  nlohmann::json zeros = sensor.flatMetadata();
  zeros["beam_altitude_angles"] = zeros["beam_azimuth_angles"] = std::vector<int>(8, 0);
  EXPECT_THAT(errorOf(zeros), HasSubstr("only zeros"));
  nlohmann::json bare = sensor.flatMetadata();
  bare.erase("beam_altitude_angles");
  EXPECT_THAT(errorOf(bare), HasSubstr("beam_altitude_angles' is missing"));
}

TEST_F(OusterMetadataFile, SaysWhatIsNoMetadata) {
  EXPECT_THAT(userErrorOf([&] { readText("{\"lidar_mode\": "); }), HasSubstr("is no JSON"));
  EXPECT_THAT(userErrorOf([&] { readText("[1, 2]"); }), HasSubstr("is no JSON object"));
  EXPECT_THAT(userErrorOf([&] { readText("{}"); }), HasSubstr("'lidar_mode' is missing"));
  EXPECT_THAT(userErrorOf([&] { readOusterMetadata(folder / "none.json"); }),
              HasSubstr("can't be read"));
}

TEST(OusterMetadataData, ReadsMetadataOfRealSensors) {
  if (dataFolder().empty()) GTEST_SKIP() << "real data is absent, set TOSS_TEST_DATA";
  const fs::path folder = dataFolder() / "ouster";
  const OusterMetadata os0 = readOusterMetadata(folder / "OS-0-128-U1_v2.3.0_1024x10.json");
  EXPECT_EQ(os0.productLine, "OS-0-128");
  EXPECT_EQ(os0.profile, OusterProfile::Rng15Rfl8Nir8);
  EXPECT_EQ(os0.beamAltitudes.size(), 128u);
  EXPECT_NEAR(os0.beamOriginForward, 0.02767, 1e-12);
  EXPECT_THAT(os0.notes, IsEmpty());
  const OusterMetadata os1 = readOusterMetadata(folder / "OS-1-64_sensor_config_reduced.json");
  EXPECT_EQ(os1.profile, OusterProfile::Legacy);
  EXPECT_EQ(os1.columnsPerFrame, 1024);
  EXPECT_NEAR(os1.beamAltitudes.at(63), -16.75 * kDegree, 1e-12);
  EXPECT_NEAR(os1.beamOriginForward, 0.012163, 1e-12);
  EXPECT_EQ(os1.notes.size(), 2u);
}

}  // namespace
}  // namespace toss::test
