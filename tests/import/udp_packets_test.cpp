// SPDX-License-Identifier: BSD-3-Clause
#include <InputFixtures.h>
#include <toss/import/UdpPackets.h>

#include <algorithm>
#include <map>
#include <numeric>

#include "CaptureFixtures.h"

namespace toss::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Pair;

struct ReadCapture {
  std::vector<std::string> payloads;
  std::vector<std::int64_t> times;
  UdpPacketReport report;
  std::vector<std::string> warnings;
};

ReadCapture readCapture(const fs::path& file) {
  UdpPacketReader reader(file);
  ReadCapture result;
  UdpPacket packet;
  while (reader.next(packet)) {
    result.payloads.emplace_back(reinterpret_cast<const char*>(packet.payload), packet.size);
    result.times.push_back(packet.captureTime);
    EXPECT_EQ(packet.sourceAddress, 0xC0000201u);
    EXPECT_EQ(packet.sourcePort, 7502);
  }
  result.report = reader.report();
  result.warnings = reader.warnings();
  EXPECT_NEAR(reader.progress(), 1.0, result.report.damage.empty() ? 0.0 : 1.0);
  return result;
}

class UdpPackets : public ::testing::Test {
 protected:
  ReadCapture read(const std::string& bytes) {
    writeBytes(folder / "a.pcap", bytes);
    return readCapture(folder / "a.pcap");
  }

  TemporaryFolder folder;
};

/// Bytes that differ from one place to the next.
std::string longPayload(std::size_t size) {
  std::string bytes(size, '\0');
  std::mt19937 random(11);
  std::generate(bytes.begin(), bytes.end(), [&] { return static_cast<char>(random()); });
  return bytes;
}

/// The datagram cut up as a network does that takes 1480 bytes at once.
std::vector<std::string> fragmentsOf(const std::string& udp, std::uint16_t identification) {
  std::vector<std::string> fragments;
  for (std::size_t at = 0; at < udp.size(); at += 1480)
    fragments.push_back(
        ethernetOf(ipv4Of(udp.substr(at, 1480), identification, at, at + 1480 < udp.size())));
  return fragments;
}

TEST_F(UdpPackets, ReadsEveryKindOfLink) {
  const std::string datagram = ipv4Of(udpOf("points"));
  const std::string vlan = std::string(12, '\x02') + networkBytes(0x88A8, 2) + networkBytes(5, 2) +
                           networkBytes(0x8100, 2) + networkBytes(7, 2) + networkBytes(0x0800, 2) +
                           datagram;
  const std::vector<std::pair<std::uint32_t, std::string>> frames = {
      {1, ethernetOf(datagram)},
      {1, ethernetOf(datagram) + std::string(20, '\0')},
      {1, vlan},
      {113, std::string(14, '\0') + networkBytes(0x0800, 2) + datagram},
      {276, networkBytes(0x0800, 2) + std::string(18, '\0') + datagram},
      {101, datagram},
      {228, datagram},
      {0, littleBytes(2, 4) + datagram},
      {108, networkBytes(2, 4) + datagram}};
  for (const auto& [link, frame] : frames) {
    SCOPED_TRACE(link);
    EXPECT_THAT(read(pcapOf({frame}, link)).payloads, ElementsAre("points"));
    EXPECT_THAT(read(pcapngOf({frame}, static_cast<std::uint16_t>(link))).payloads,
                ElementsAre("points"));
  }
}

TEST_F(UdpPackets, TellsTheTime) {
  const std::vector<std::string> frames(2, ethernetOf(ipv4Of(udpOf("x"))));
  for (const std::string& file : {pcapOf(frames), pcapngOf(frames)})
    EXPECT_THAT(read(file).times,
                ElementsAre(1'600'000'000'000'000'000, 1'600'000'000'001'000'000));
}

TEST_F(UdpPackets, PassesOverOtherTraffic) {
  const ReadCapture result =
      read(pcapOf({std::string(12, '\x02') + networkBytes(0x0806, 2) + std::string(28, '\0'),
                   ethernetOf(ipv4Of("tcp", 1, 0, false, 6)), ethernetOf(ipv4Of(udpOf("a")))}));
  EXPECT_THAT(result.payloads, ElementsAre("a"));
  EXPECT_EQ(result.report.otherFrames, 2u);
  EXPECT_THAT(result.warnings, IsEmpty());
}

TEST_F(UdpPackets, PutsFragmentsTogetherInAnyOrder) {
  const std::string payload = longPayload(24832);
  std::vector<std::string> frames = fragmentsOf(udpOf(payload), 9);
  ASSERT_EQ(frames.size(), 17u);
  const std::vector<std::string> others = fragmentsOf(udpOf(longPayload(3000)), 10);
  frames.insert(frames.end(), others.begin(), others.end());
  std::mt19937 random(2);
  for (int trial = 0; trial < 20; ++trial) {
    std::shuffle(frames.begin(), frames.end(), random);
    const ReadCapture result = read(pcapOf(frames));
    EXPECT_THAT(result.payloads, ::testing::UnorderedElementsAre(payload, longPayload(3000)));
    EXPECT_EQ(result.report.incompletePackets, 0u);
  }
}

TEST_F(UdpPackets, CountsWhatFragmentsLeaveIncomplete) {
  std::vector<std::string> frames = fragmentsOf(udpOf(longPayload(6000)), 9);
  frames.erase(frames.begin() + 2);
  frames.push_back(ethernetOf(ipv4Of(udpOf("whole"), 12)));
  const ReadCapture result = read(pcapOf(frames));
  EXPECT_THAT(result.payloads, ElementsAre("whole"));
  EXPECT_EQ(result.report.incompletePackets, 1u);
  EXPECT_THAT(result.warnings, ElementsAre(HasSubstr("1 packets were left out")));
}

TEST_F(UdpPackets, RefusesFragmentsThatContradictEachOther) {
  // The last fragment ends before another one: neither may be read past its end.
  const std::string part(1480, 'p');
  const ReadCapture result = read(
      pcapOf({ethernetOf(ipv4Of(part, 3, 2960, true)), ethernetOf(ipv4Of(part, 3, 1480, false)),
              ethernetOf(ipv4Of(part, 4, 65528, true))}));
  EXPECT_THAT(result.payloads, IsEmpty());
  EXPECT_EQ(result.report.incompletePackets, 2u);
}

TEST_F(UdpPackets, CountsFramesThatAreNotWhole) {
  const std::string frame = ethernetOf(ipv4Of(udpOf("points")));
  std::string wrongLength = frame;
  wrongLength[14 + 20 + 5] = '\x7F';
  const ReadCapture result = read(pcapOf({frame.substr(0, 36), wrongLength, frame}));
  EXPECT_THAT(result.payloads, ElementsAre("points"));
  EXPECT_EQ(result.report.cutFrames, 2u);
  EXPECT_THAT(result.warnings, ElementsAre(HasSubstr("snap length")));
}

TEST_F(UdpPackets, SurvivesAFileThatIsCut) {
  const std::vector<std::string> frames(5, ethernetOf(ipv4Of(udpOf("points"))));
  for (const std::string& whole : {pcapOf(frames), pcapngOf(frames)})
    for (std::size_t size = 60; size < whole.size(); size += 7) {
      SCOPED_TRACE(size);
      const ReadCapture result = read(whole.substr(0, size));
      EXPECT_LT(result.payloads.size(), 5u);
      EXPECT_EQ(result.warnings.size(), result.report.damage.empty() ? 0u : 1u);
    }
  const ReadCapture cut = read(pcapOf(frames).substr(0, pcapOf(frames).size() - 1));
  EXPECT_EQ(cut.payloads.size(), 4u);
  EXPECT_THAT(cut.warnings, ElementsAre(HasSubstr("cut short after frame 4")));
}

TEST_F(UdpPackets, SurvivesRandomDamage) {
  std::vector<std::string> frames = fragmentsOf(udpOf(longPayload(6000)), 9);
  frames.push_back(ethernetOf(ipv4Of(udpOf("whole"), 12)));
  const std::string whole = pcapOf(frames);
  std::mt19937 random(4);
  for (int trial = 0; trial < 100; ++trial) {
    std::string damaged = whole;
    for (int i = 0; i < 8; ++i)
      damaged[24 + random() % (damaged.size() - 24)] = static_cast<char>(random());
    writeBytes(folder / "a.pcap", damaged);
    UdpPacketReader reader(folder / "a.pcap");
    UdpPacket packet;
    std::uint64_t sum = 0;
    while (reader.next(packet))
      sum = std::accumulate(packet.payload, packet.payload + packet.size, sum);
    EXPECT_LE(reader.report().packets, frames.size());
  }
}

TEST_F(UdpPackets, SaysWhatIsNoCapture) {
  const auto errorOf = [&](const std::string& bytes) {
    writeBytes(folder / "a.pcap", bytes);
    return userErrorOf([&] { UdpPacketReader reader(folder / "a.pcap"); });
  };
  EXPECT_THAT(errorOf(""), HasSubstr("can't be read as a capture"));
  EXPECT_THAT(errorOf("some text that is no capture at all"), HasSubstr("a.pcap"));
  EXPECT_THAT(errorOf(pcapOf({}, 105)), HasSubstr("is not known"));
  EXPECT_THAT(userErrorOf([&] { UdpPacketReader reader(folder / "none.pcap"); }),
              HasSubstr("is no file"));
}

TEST(UdpPacketsData, ReadsRealCaptures) {
  if (dataFolder().empty()) GTEST_SKIP() << "real data is absent, set TOSS_TEST_DATA";
  UdpPacketReader reader(dataFolder() / "ouster/OS-0-128-U1_v2.3.0_1024x10.pcap");
  UdpPacket packet;
  std::map<std::pair<int, std::size_t>, int> packets;
  while (reader.next(packet)) ++packets[{packet.destinationPort, packet.size}];
  // 64 of the LiDAR, 10 of its inertial unit.
  EXPECT_THAT(packets, ElementsAre(Pair(Pair(7502, 8448u), 64), Pair(Pair(7503, 48u), 10)));
  EXPECT_THAT(reader.warnings(), IsEmpty());
}

}  // namespace
}  // namespace toss::test
