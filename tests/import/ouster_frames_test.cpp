// SPDX-License-Identifier: BSD-3-Clause
#include <InputFixtures.h>
#include <mrpt/system/md5.h>
#include <toss/import/OusterFrames.h>

#include <algorithm>

#include "OusterFixtures.h"

namespace toss::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

struct ReadFrames {
  std::vector<OusterFrame> frames;
  OusterFrameReport report;
  std::vector<std::string> warnings;
};

class OusterFrames : public ::testing::Test {
 protected:
  OusterMetadata metadata() {
    writeBytes(folder / "meta.json", sensor.flatMetadata().dump());
    return readOusterMetadata(folder / "meta.json");
  }
  ReadFrames read(const std::vector<std::string>& ethernet) {
    writeBytes(folder / "a.pcap", pcapOf(ethernet));
    OusterFrameReader reader(folder / "a.pcap", metadata());
    ReadFrames result;
    for (OusterFrame frame; reader.next(frame);) result.frames.push_back(frame);
    result.report = reader.report();
    result.warnings = reader.warnings();
    return result;
  }
  ReadFrames readPayloads(const std::vector<std::string>& payloads) {
    return read(sensor.frames(payloads));
  }

  TemporaryFolder folder;
  FakeOuster sensor;
};

TEST_F(OusterFrames, DecodesEveryProfile) {
  sensor.scene = [](int frame, int row, int column) {
    // Multiples of 8: the smallest unit of all profiles.
    const auto mix =
        static_cast<std::uint32_t>((frame * 31 + row * 7919 + column * 104729) % 32768);
    return OusterPixel{8 * (mix % 32000), 8 * (mix / 2), static_cast<std::uint16_t>(mix % 256),
                       static_cast<std::uint16_t>(mix / 128)};
  };
  for (const OusterProfile profile :
       {OusterProfile::Legacy, OusterProfile::Rng19Rfl8Sig16Nir16,
        OusterProfile::Rng19Rfl8Sig16Nir16Dual, OusterProfile::Rng15Rfl8Nir8}) {
    SCOPED_TRACE(nameOf(profile));
    sensor.profile = profile;
    const ReadFrames result = readPayloads(sensor.payloads(2));
    ASSERT_EQ(result.frames.size(), 2u);
    EXPECT_THAT(result.warnings, IsEmpty());
    for (int f = 0; f < 2; ++f) {
      const OusterFrame& frame = result.frames[static_cast<std::size_t>(f)];
      EXPECT_EQ(frame.id, f);
      EXPECT_EQ(frame.validColumns(), 512);
      const bool dual = profile == OusterProfile::Rng19Rfl8Sig16Nir16Dual;
      EXPECT_EQ(frame.returns[1].range.size(), dual ? 8u * 512u : 0u);
      for (int row = 0; row < 8; ++row)
        for (int column = 0; column < 512; ++column) {
          const auto pixel = static_cast<std::size_t>(row * 512 + column);
          const OusterPixel shown = sensor.scene(f, row, column);
          ASSERT_EQ(frame.returns[0].range[pixel], shown.range);
          ASSERT_EQ(frame.returns[0].reflectivity[pixel], shown.reflectivity);
          if (!dual) continue;
          ASSERT_EQ(frame.returns[1].range[pixel], shown.range2);
          ASSERT_EQ(frame.returns[1].reflectivity[pixel], shown.reflectivity2);
        }
      EXPECT_EQ(frame.timestamp[511], sensor.timeOf(f, 511));
    }
  }
}

TEST_F(OusterFrames, CountsColumnsThatAreMissingOrNotMeasured) {
  for (const OusterProfile profile : {OusterProfile::Legacy, OusterProfile::Rng15Rfl8Nir8}) {
    sensor.profile = profile;
    std::vector<std::string> payloads = sensor.payloads(3);
    payloads[40] = sensor.packet(1, 8 * 16, false);
    payloads.erase(payloads.begin() + 50, payloads.begin() + 53);
    const ReadFrames result = readPayloads(payloads);
    ASSERT_EQ(result.frames.size(), 3u);
    EXPECT_EQ(result.frames[1].validColumns(), 512 - 4 * 16);
    EXPECT_EQ(result.report.lostColumns, 64u);
    EXPECT_THAT(result.warnings, ElementsAre(HasSubstr("64 columns are missing")));
  }
}

TEST_F(OusterFrames, CountsFramesOfWhichNothingCame) {
  std::vector<std::string> payloads = sensor.payloads(1);
  const std::vector<std::string> later = sensor.payloads(1, 4);
  payloads.insert(payloads.end(), later.begin(), later.end());
  const ReadFrames result = readPayloads(payloads);
  EXPECT_EQ(result.report.frames, 2u);
  EXPECT_EQ(result.report.lostFrames, 3u);
}

TEST_F(OusterFrames, SortsPacketsThatOvertakeEachOther) {
  std::vector<std::string> payloads = sensor.payloads(3);
  std::swap(payloads[3], payloads[9]);
  // The last packet of frame 0 comes within frame 1, which is too late.
  std::rotate(payloads.begin() + 31, payloads.begin() + 32, payloads.begin() + 36);
  const ReadFrames result = readPayloads(payloads);
  ASSERT_EQ(result.frames.size(), 3u);
  EXPECT_EQ(result.frames[0].validColumns(), 512 - 16);
  EXPECT_EQ(result.frames[1].validColumns(), 512);
  EXPECT_EQ(result.report.late, 1u);
  EXPECT_THAT(result.warnings, ::testing::Contains(HasSubstr("after their frame was over")));
}

TEST_F(OusterFrames, GoesOnWhereTheFrameCounterWrapsOrBeginsAnew) {
  std::vector<std::string> payloads;
  for (const int first : {65535, 65536, 300, 0}) {
    const std::vector<std::string> more = sensor.payloads(1, first);
    payloads.insert(payloads.end(), more.begin(), more.end());
  }
  const ReadFrames result = readPayloads(payloads);
  EXPECT_EQ(result.report.frames, 4u);
  EXPECT_EQ(result.report.late, 0u);
}

TEST_F(OusterFrames, LeavesOutPacketsOfTheWrongSize) {
  std::vector<std::string> payloads = sensor.payloads(2);
  payloads[5].pop_back();
  payloads[6] += "more";
  const ReadFrames result = readPayloads(payloads);
  EXPECT_EQ(result.report.wrongSize, 2u);
  EXPECT_EQ(result.report.lostColumns, 32u);
  EXPECT_THAT(result.warnings, ::testing::Contains(HasSubstr("their size is not the one")));
}

TEST_F(OusterFrames, ChecksTheSumsOfSensorsThatSendThem) {
  sensor.checkSums = true;
  std::vector<std::string> payloads = sensor.payloads(2);
  EXPECT_EQ(readPayloads(payloads).report.wrongCheckSum, 0u);
  payloads[5][100] = static_cast<char>(payloads[5][100] ^ 1);
  payloads[6][8] = static_cast<char>(payloads[6][8] ^ 1);
  const ReadFrames result = readPayloads(payloads);
  EXPECT_EQ(result.report.wrongCheckSum, 2u);
  EXPECT_EQ(result.report.otherSensors, 0u);
  EXPECT_EQ(result.report.lostColumns, 32u);
  EXPECT_EQ(FakeOuster::checkSumOf("123456789"), 0x995DC9BBDF1939FAu) << "the published value";
}

TEST_F(OusterFrames, TakesOneSensorOfSeveral) {
  for (const OusterProfile profile : {OusterProfile::Legacy, OusterProfile::Rng19Rfl8Sig16Nir16}) {
    sensor.profile = profile;
    FakeOuster other = sensor;
    other.serialNumber = 99;
    other.port = 7602;
    other.scene = [](int, int, int) { return OusterPixel{99, 99, 9, 9}; };
    const std::vector<std::string> ours = sensor.frames(sensor.payloads(2));
    const std::vector<std::string> theirs = other.frames(other.payloads(2));
    std::vector<std::string> mixed;
    for (std::size_t i = 0; i < ours.size(); ++i) {
      mixed.push_back(theirs[i]);
      mixed.push_back(ours[i]);
    }
    const ReadFrames result = read(mixed);
    ASSERT_EQ(result.frames.size(), 2u);
    EXPECT_EQ(result.report.lostColumns, 0u);
    EXPECT_EQ(result.report.otherSensors, 64u);
    const std::vector<std::uint32_t>& range = result.frames[1].returns[0].range;
    EXPECT_EQ(std::count(range.begin(), range.end(), 10000u), 8 * 512);
    EXPECT_THAT(result.warnings, ElementsAre(HasSubstr("64 packets of other sensors")));
  }
}

TEST_F(OusterFrames, SaysWhereMetadataAndCaptureDoNotBelongTogether) {
  const std::vector<std::string> frames = sensor.frames(sensor.payloads(1));
  sensor.rows = 16;
  EXPECT_THAT(userErrorOf([&] { read(frames); }),
              ::testing::AllOf(HasSubstr("holds no packets of"), HasSubstr("to port 7502")));
  sensor.rows = 8;
  sensor.serialNumber = 77;
  EXPECT_THAT(userErrorOf([&] { read(frames); }),
              ::testing::AllOf(HasSubstr("of sensor 122201000998"), HasSubstr("of sensor 77")));
  EXPECT_THAT(userErrorOf([&] { read({}); }), HasSubstr("nor any other UDP packet"));
  sensor.serialNumber = 122201000998;
  sensor.initializationId = 5;
  EXPECT_THAT(read(frames).warnings, ElementsAre(HasSubstr("was started anew")));
}

TEST_F(OusterFrames, SurvivesRandomDamage) {
  sensor.profile = OusterProfile::Legacy;
  std::mt19937 random(8);
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<std::string> payloads = sensor.payloads(2);
    for (std::string& payload : payloads)
      for (int i = 0; i < 30; ++i) payload[random() % payload.size()] = static_cast<char>(random());
    const ReadFrames result = readPayloads(payloads);
    EXPECT_EQ(result.report.packets + result.report.late, 64u);
  }
}

/// MD5 of the numbers in memory, each as wide as the digest has it.
template <typename Stored, typename Number>
std::string digestOf(const std::vector<Number>& numbers) {
  const std::vector<Stored> stored(numbers.begin(), numbers.end());
  return mrpt::system::md5(reinterpret_cast<const unsigned char*>(stored.data()),
                           stored.size() * sizeof(Stored));
}

TEST(OusterFramesData, DecodesARealScanAsItsDigestSays) {
  if (dataFolder().empty()) GTEST_SKIP() << "real data is absent, set TOSS_TEST_DATA";
  const fs::path stem = dataFolder() / "ouster/OS-0-128-U1_v2.3.0_1024x10";
  OusterFrameReader reader(stem.string() + ".pcap", readOusterMetadata(stem.string() + ".json"));
  OusterFrame frame;
  ASSERT_TRUE(reader.next(frame));
  const nlohmann::json scan =
      nlohmann::json::parse(readBytes(stem.string() + "_digest.json")).at("scans").at(0);
  EXPECT_EQ(std::to_string(frame.id), scan.at("FRAME_ID"));
  EXPECT_EQ(digestOf<std::uint64_t>(frame.timestamp), scan.at("TIMESTAMP"));
  EXPECT_EQ(digestOf<std::uint64_t>(frame.status), scan.at("STATUS"));
  EXPECT_EQ(digestOf<std::uint16_t>(frame.measurementId), scan.at("MEASUREMENT_ID"));
  EXPECT_EQ(digestOf<std::uint32_t>(frame.returns[0].range), scan.at("RANGE"));
  EXPECT_EQ(digestOf<std::uint8_t>(frame.returns[0].reflectivity), scan.at("REFLECTIVITY"));
  EXPECT_FALSE(reader.next(frame));
  EXPECT_THAT(reader.warnings(), IsEmpty());
  EXPECT_EQ(reader.progress(), 1.0);
}

}  // namespace
}  // namespace toss::test
