// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/maps/CPointsMapXYZI.h>
#include <sys/resource.h>
#include <toss/rawlog/PlyFile.h>

#include <csignal>

#include "InputFixtures.h"

namespace toss::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

bool samePoints(const std::vector<MapPoint>& a, const std::vector<MapPoint>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(MapPoint)) == 0;
}

std::vector<MapPoint> randomPoints(std::size_t count) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> value(-200.0f, 200.0f);
  std::vector<MapPoint> points(count);
  for (MapPoint& point : points)
    point = {value(random), value(random), value(random), std::abs(value(random)) / 200.0f};
  return points;
}

template <typename... Values>
std::string bytesOf(Values... values) {
  std::string bytes;
  (bytes.append(reinterpret_cast<const char*>(&values), sizeof values), ...);
  return bytes;
}

class PlyTest : public ::testing::Test {
 protected:
  std::vector<MapPoint> read(const std::string& bytes, const std::string& name = "map.ply") {
    writeBytes(folder / name, bytes);
    return readPointCloudFile(folder / name);
  }
  std::string errorOf(const std::string& bytes, const std::string& name = "map.ply") {
    return userErrorOf([&] { read(bytes, name); });
  }
  TemporaryFolder folder;
};

TEST_F(PlyTest, GivesBackEveryBit) {
  for (const std::size_t count : {0u, 1u, 4095u, 4096u, 10001u}) {
    const std::vector<MapPoint> points = randomPoints(count);
    writePly(folder / "map.ply", points);
    EXPECT_TRUE(samePoints(readPointCloudFile(folder / "map.ply"), points)) << count;
  }
}

TEST_F(PlyTest, IsReadByMrptWithIntensity) {
  const std::vector<MapPoint> points = randomPoints(500);
  writePly(folder / "map.ply", points);
  mrpt::maps::CPointsMapXYZI map;
  ASSERT_TRUE(map.loadFromPlyFile((folder / "map.ply").string()));
  ASSERT_EQ(map.size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    float x = 0, y = 0, z = 0;
    map.getPoint(i, x, y, z);
    EXPECT_EQ(x, points[i].x);
    EXPECT_EQ(y, points[i].y);
    EXPECT_EQ(z, points[i].z);
    EXPECT_EQ(map.getPointIntensity(i), points[i].intensity);
  }
}

TEST_F(PlyTest, HasTheDocumentedLayout) {
  PlyWriter writer(folder / "moving.ply", PlyWriter::Layout::PointsWithTrack);
  writer.add({1.0f, 2.0f, 3.0f, 0.5f}, 77);
  writer.add({4.0f, 5.0f, 6.0f, 0.25f});
  EXPECT_FALSE(fs::exists(folder / "moving.ply"));
  writer.finish();
  const std::string bytes = readBytes(folder / "moving.ply");
  EXPECT_THAT(bytes, AllOf(::testing::StartsWith("ply\nformat binary_little_endian 1.0\n"),
                           HasSubstr("\nelement vertex 2\nproperty float x\nproperty float y\n"
                                     "property float z\nproperty float intensity\n"
                                     "property float track\nend_header\n")));
  EXPECT_THAT(bytes, ::testing::EndsWith("end_header\n" + bytesOf(1.0f, 2.0f, 3.0f, 0.5f, 77.0f,
                                                                  4.0f, 5.0f, 6.0f, 0.25f, 0.0f)));
}

TEST_F(PlyTest, LeavesNothingBehindWhenItIsNotFinished) {
  {
    PlyWriter writer(folder / "map.ply", PlyWriter::Layout::Points);
    for (const MapPoint& point : randomPoints(10000)) writer.add(point);
  }
  EXPECT_TRUE(fs::is_empty(folder / ""));
}

TEST_F(PlyTest, KeepsThePrecisionOfFarMapsThroughItsOffset) {
  const Eigen::Vector3d offset(500000.25, 4500000.5, 100.0);
  writePly(folder / "map.ply", {{0.125f, -3.0f, 1.5f, 1.0f}}, offset);
  Eigen::Vector3d readOffset;
  const auto points = readPointCloudFile(folder / "map.ply", readOffset);
  EXPECT_EQ(readOffset, offset);
  EXPECT_EQ(points.at(0).x, 0.125f);
  EXPECT_EQ(readPointCloudFile(folder / "map.ply").at(0).z, 101.5f);
}

TEST_F(PlyTest, ShiftsFarDoublesWithoutOffsetToTheFirstPoint) {
  const std::string header =
      "ply\nformat binary_little_endian 1.0\nelement vertex 2\nproperty double x\n"
      "property double y\nproperty double z\nend_header\n";
  writeBytes(folder / "utm.ply",
             header + bytesOf(500000.4, 4500000.0, 7.0) + bytesOf(500000.5, 4500000.25, 7.0));
  Eigen::Vector3d offset;
  const auto points = readPointCloudFile(folder / "utm.ply", offset);
  EXPECT_EQ(offset, Eigen::Vector3d(500000.0, 4500000.0, 7.0));
  EXPECT_FLOAT_EQ(points.at(1).x, 0.5f);
  EXPECT_FLOAT_EQ(points.at(1).y, 0.25f);
}

TEST_F(PlyTest, ReadsAnyOrderAndTypeOfProperties) {
  const std::string header =
      "ply\r\nformat binary_little_endian 1.0\r\nobj_info by hand\r\nelement camera 1\r\n"
      "property double zoom\r\nelement vertex 1\r\nproperty uchar red\r\nproperty double z\r\n"
      "property uchar intensity\r\nproperty short x\r\nproperty float y\r\n"
      "element face 1\r\nproperty list uchar int vertex_indices\r\nend_header\r\n";
  const auto points =
      read(header + bytesOf(2.5) +
           bytesOf(std::uint8_t{9}, -1.25, std::uint8_t{200}, std::int16_t{-7}, 3.5f) + "rest");
  ASSERT_EQ(points.size(), 1u);
  EXPECT_TRUE(samePoints(points, {{-7.0f, 3.5f, -1.25f, 200.0f}}));
}

TEST_F(PlyTest, ReadsBigEndianAndAscii) {
  std::string big = bytesOf(3.0f, 2.0f, 1.0f);
  std::reverse(big.begin(), big.end());
  const std::string properties = "property float x\nproperty float y\nproperty float z\n";
  EXPECT_TRUE(samePoints(read("ply\nformat binary_big_endian 1.0\nelement vertex 1\n" + properties +
                              "end_header\n" + big),
                         {{1.0f, 2.0f, 3.0f, 0.0f}}));
  EXPECT_TRUE(samePoints(read("ply\nformat ascii 1.0\nelement vertex 3\n" + properties +
                              "property float intensity\nend_header\n1 2 3 .5\n\n"
                              "nan 0 0 1\n-1e1\t+2 3.25 1"),
                         {{1.0f, 2.0f, 3.0f, 0.5f}, {-10.0f, 2.0f, 3.25f, 1.0f}}));
}

TEST_F(PlyTest, ReadsPcd) {
  const std::string header =
      "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z _ intensity\nSIZE 4 4 4 1 4\nTYPE F F F U F\n"
      "COUNT 1 1 1 3 1\nWIDTH 2\nHEIGHT 1\nVIEWPOINT 9 9 9 1 0 0 0\nPOINTS 2\n";
  const std::vector<MapPoint> expected = {{1, 2, 3, 0.5f}, {4, 5, 6, 0.25f}};
  EXPECT_TRUE(samePoints(read(header + "DATA ascii\n1 2 3 0 0 0 0.5\n4 5 6 0 0 0 0.25\n", "a.pcd"),
                         expected));
  EXPECT_TRUE(samePoints(read(header + "DATA binary\n" + bytesOf(1.0f, 2.0f, 3.0f) + "abc" +
                                  bytesOf(0.5f, 4.0f, 5.0f, 6.0f) + "abc" + bytesOf(0.25f),
                              "b.pcd"),
                         expected));
}

TEST_F(PlyTest, NamesWhatIsWrongWithAFile) {
  const std::string begin = "ply\nformat ascii 1.0\nelement vertex 2\n";
  const std::string properties = "property float x\nproperty float y\nproperty float z\n";
  const std::pair<std::string, std::string> cases[] = {
      {"", "is empty"},
      {"hello, world", "neither PLY nor PCD"},
      {"ply\nformat ascii 1.0\n", "no end"},
      {"ply\nformat ascii 1.0\n" + std::string(9000, 'x'), "header is damaged"},
      {"ply\nelement vertex 1\n" + properties + "end_header\n1 2 3\n", "no format"},
      {"ply\nformat ascii 1.0\nend_header\n", "no element vertex"},
      {begin + "property float x\nproperty float y\nend_header\n1 2\n3 4\n", "coordinate 'z'"},
      {begin + "property long x\nend_header\n", "unknown type long"},
      {begin + "property list uchar int x\nend_header\n", "lists"},
      {begin + properties + "end_header\n1 2 3\n", "cut short"},
      {begin + properties + "end_header\n1 2 3\n4 5      \n", "point 1 has only 2"},
      {begin + properties + "end_header\n1 2 3\n4 five 6\n", "point 1 is no row"},
      {"ply\nformat ascii 1.0\nelement vertex -3\n", "no number"},
      {"ply\nformat binary_little_endian 1.0\nelement vertex 18446744073709551615\n" + properties +
           "end_header\n123456789012",
       "cut short"},
      {"ply\nformat binary_little_endian 1.0\nelement pose 99999\nproperty double a\n"
       "element vertex 1\n" +
           properties + "end_header\n123456789012",
       "cut short"},
      {"VERSION 0.7\nFIELDS x y z\nSIZE 4 4\nTYPE F F F\nPOINTS 1\nDATA ascii\n",
       "differ in number"},
      {"VERSION 0.7\nFIELDS x\nSIZE 4\nTYPE F\nDATA ascii\n", "number of points"},
      {"VERSION 0.7\nFIELDS x y z\nSIZE 4 4 3\nTYPE F F F\nPOINTS 1\nDATA ascii\n", "type F3"},
      {"VERSION 0.7\nFIELDS x y z\n", "no line DATA"}};
  for (const auto& [bytes, problem] : cases)
    EXPECT_THAT(errorOf(bytes), AllOf(HasSubstr("map.ply"), HasSubstr(problem))) << bytes;
  EXPECT_THAT(userErrorOf([&] { readPointCloudFile(folder / "none.ply"); }), HasSubstr("none.ply"));
}

TEST_F(PlyTest, EveryCutOfAFileIsNoticed) {
  writePly(folder / "map.ply", randomPoints(3));
  const std::string whole = readBytes(folder / "map.ply");
  for (std::size_t length = 0; length < whole.size(); ++length)
    EXPECT_NE(errorOf(whole.substr(0, length)), "") << length;
}

TEST_F(PlyTest, TellsOfAFullDisk) {
  const auto points = randomPoints(10000);
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  rlimit small = before;
  small.rlim_cur = 50000;
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  const std::string error = userErrorOf([&] { writePly(folder / "map.ply", points); });
  ::setrlimit(RLIMIT_FSIZE, &before);
  EXPECT_THAT(error, AllOf(HasSubstr("map.ply"), HasSubstr("can not be written")));
  EXPECT_TRUE(fs::is_empty(folder / ""));
}

}  // namespace
}  // namespace toss::test
