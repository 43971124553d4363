// SPDX-License-Identifier: BSD-3-Clause
#include <InputFixtures.h>
#include <PcdFixtures.h>
#include <toss/rawlog/PcdFile.h>
#include <toss/rawlog/PlyFile.h>

namespace toss::test {
namespace {

using ::testing::HasSubstr;

std::vector<MapPoint> somePoints(std::size_t count) {
  std::vector<MapPoint> points;
  for (std::size_t i = 0; i < count; ++i) {
    const auto f = static_cast<float>(i);
    points.push_back({0.25f * f, -1.5f * f, 3.0f + f, f / 64.0f});
  }
  return points;
}

bool samePoints(const std::vector<MapPoint>& a, const std::vector<MapPoint>& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(MapPoint)) == 0);
}

class PcdTest : public ::testing::Test {
 protected:
  PcdScan read(const std::string& bytes) {
    writeBytes(folder / "a.pcd", bytes);
    return readPcdScan(folder / "a.pcd");
  }
  std::string errorOf(const std::string& bytes) {
    return userErrorOf([&] { read(bytes); });
  }

  TemporaryFolder folder;
};

TEST_F(PcdTest, ReadsAllKindsOfDataWithTheViewpoint) {
  const Eigen::Isometry3d pose = poseOf(10.5, -3.25, 1.0, 0.7, -0.1, 0.05);
  for (const PcdData data : {PcdData::Ascii, PcdData::Binary, PcdData::Compressed})
    for (const std::size_t count : {0u, 1u, 100u}) {
      const PcdScan scan = read(pcdOf(somePoints(count), data, viewpointOf(pose)));
      EXPECT_TRUE(samePoints(scan.points, somePoints(count)));
      ASSERT_TRUE(scan.viewpoint);
      EXPECT_TRUE(scan.viewpoint->isApprox(pose, 1e-9));
      EXPECT_TRUE(samePoints(readPointCloudFile(folder / "a.pcd"), somePoints(count)));
    }
  EXPECT_FALSE(read(pcdOf(somePoints(3), PcdData::Binary, "")).viewpoint);
}

TEST_F(PcdTest, UnpacksRepeatedBytes) {
  // x = y = z = intensity = 0: one literal byte, then 15 bytes copied from one byte back (LZF: a
  // length of 7 + 6 + 2 in the long form).
  const std::string packed = {'\0', '\0', '\xE0', '\x06', '\0'};
  const PcdScan scan = read(pcdHeader(1, "0 0 0 1 0 0 0") + "DATA binary_compressed\n" +
                            bytesOfNumber(5) + bytesOfNumber(16) + packed);
  EXPECT_TRUE(samePoints(scan.points, {MapPoint{0, 0, 0, 0}}));
}

TEST_F(PcdTest, SaysWhatIsWrongWithCompressedPoints) {
  const std::string good = pcdOf(somePoints(20), PcdData::Compressed, "");
  const std::size_t sizes = good.find("compressed\n") + 11;
  std::string wrongSize = good, tooLong = good, damaged = good;
  wrongSize[sizes + 4] = '\x01';
  tooLong[sizes + 1] = '\x7F';
  // The first control byte now asks for a copy from before the beginning.
  damaged[sizes + 8] = '\xFF';
  EXPECT_THAT(errorOf(wrongSize), HasSubstr("not that of its header"));
  EXPECT_THAT(errorOf(tooLong), HasSubstr("cut short within"));
  EXPECT_THAT(errorOf(damaged), HasSubstr("are damaged"));
  EXPECT_THAT(errorOf(good.substr(0, sizes + 5)), HasSubstr("cut short before"));
  EXPECT_THAT(errorOf(good.substr(0, good.size() - 1)), HasSubstr("cut short within"));
  std::string many = good;
  many.replace(many.find("POINTS 20"), 9, "POINTS 4000000000");
  EXPECT_THAT(errorOf(many), HasSubstr("more points than"));
  EXPECT_THAT(errorOf(pcdHeader(1, "") + "DATA packed\n"), HasSubstr("neither ascii"));
}

TEST_F(PcdTest, SurvivesRandomDamage) {
  const std::string good = pcdOf(somePoints(50), PcdData::Compressed, "0 0 0 1 0 0 0");
  std::mt19937 random(6);
  int errors = 0;
  for (int trial = 0; trial < 200; ++trial) {
    std::string damaged = good;
    for (int i = 0; i < 3; ++i) damaged[random() % damaged.size()] = static_cast<char>(random());
    errors += !errorOf(damaged).empty();
  }
  EXPECT_GT(errors, 0);
}

TEST_F(PcdTest, RefusesViewpointsThatAreNoPose) {
  for (const std::string viewpoint :
       {"1 2 3", "1 2 3 0 0 0 0", "1 2 x 1 0 0 0", "nan 0 0 1 0 0 0", "0 0 0 2 0 0 0"})
    EXPECT_THAT(errorOf(pcdOf(somePoints(1), PcdData::Ascii, viewpoint)), HasSubstr("VIEWPOINT"))
        << viewpoint;
}

}  // namespace
}  // namespace toss::test
