// SPDX-License-Identifier: BSD-3-Clause
#include <toss/rawlog/TracksCsv.h>

#include "InputFixtures.h"

namespace toss::test {
namespace {

const std::string kHeader = "scan,time,track,class,x,y,z,yaw,l,w,h,vx,vy,vz\n";

TrackSample sampleOf(TrackId track, bool moving) {
  TrackSample sample;
  sample.track = track;
  sample.moving = moving;
  sample.box.center = {1.25, -2.5, 0.125};
  sample.box.yaw = -0.5;
  sample.box.length = 4.5;
  sample.box.width = 1.8;
  sample.box.height = 1.5;
  sample.velocity = {8.0, -0.25, 0.0};
  return sample;
}

ScanLabels labelsWith(std::uint64_t scan, std::vector<TrackSample> tracks) {
  ScanLabels labels;
  labels.scan = scan;
  labels.time = 1.6e9 + 0.1 * static_cast<double>(scan);
  labels.tracks = std::move(tracks);
  return labels;
}

class TracksCsvTest : public ::testing::Test {
 protected:
  fs::path write(const std::vector<ScanLabels>& scans) {
    TracksCsvWriter writer(folder / "tracks.csv");
    for (const ScanLabels& labels : scans) writer.add(labels);
    writer.finish();
    return folder / "tracks.csv";
  }
  std::string errorOf(const std::string& text) {
    writeBytes(folder / "bad.csv", text);
    return userErrorOf([&] { readTracksCsv(folder / "bad.csv"); });
  }
  TemporaryFolder folder;
};

TEST_F(TracksCsvTest, HasTheDocumentedText) {
  const auto file =
      write({labelsWith(0, {}), labelsWith(7, {sampleOf(3, true), sampleOf(9, false)})});
  const std::string numbers =
      ",1.2500,-2.5000,0.1250,-0.5000,4.5000,1.8000,1.5000,8.0000,-0.2500,0.0000\n";
  EXPECT_EQ(readBytes(file), kHeader + "7,1600000000.700000,3,moving" + numbers +
                                 "7,1600000000.700000,9,static" + numbers);
}

TEST_F(TracksCsvTest, IsReadBack) {
  const auto rows = readTracksCsv(
      write({labelsWith(1, {sampleOf(5, true)}), labelsWith(2, {sampleOf(5, false)})}));
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].scan, 1u);
  EXPECT_NEAR(rows[1].time, 1.6e9 + 0.2, 1e-6);
  EXPECT_TRUE(rows[0].sample.moving);
  EXPECT_FALSE(rows[1].sample.moving);
  const TrackSample expected = sampleOf(5, true);
  EXPECT_EQ(rows[0].sample.track, expected.track);
  EXPECT_EQ(rows[0].sample.box.center, expected.box.center);
  EXPECT_EQ(rows[0].sample.box.yaw, expected.box.yaw);
  EXPECT_EQ(rows[0].sample.box.length, expected.box.length);
  EXPECT_EQ(rows[0].sample.box.width, expected.box.width);
  EXPECT_EQ(rows[0].sample.box.height, expected.box.height);
  EXPECT_EQ(rows[0].sample.velocity, expected.velocity);
}

TEST_F(TracksCsvTest, FindsColumnsByName) {
  writeBytes(folder / "other.csv",
             "note,vz,vy,vx,h,w,l,yaw,z,y,x,class,track,time,scan\r\n"
             "a,1,2,3,4,5,6,7,8,9,10,moving,11,12.5,13\r\n\r\n");
  const auto rows = readTracksCsv(folder / "other.csv");
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].scan, 13u);
  EXPECT_EQ(rows[0].time, 12.5);
  EXPECT_EQ(rows[0].sample.box.center, Eigen::Vector3d(10, 9, 8));
  EXPECT_EQ(rows[0].sample.velocity, Eigen::Vector3d(3, 2, 1));
}

TEST_F(TracksCsvTest, NamesTheLineThatIsWrong) {
  using ::testing::HasSubstr;
  const std::string row = "0,0.0,1,moving,1,2,3,4,5,6,7,8,9,10\n";
  EXPECT_EQ(errorOf(kHeader + row), "");
  EXPECT_THAT(errorOf(""), HasSubstr("bad.csv"));
  EXPECT_THAT(errorOf("scan,time\n"), HasSubstr("line 1: has no column 'track'"));
  EXPECT_THAT(errorOf(kHeader + row + "1,2,3\n"), HasSubstr("line 3: has only 3 cells"));
  EXPECT_THAT(errorOf(kHeader + "0,0.0,1,flying,1,2,3,4,5,6,7,8,9,10\n"), HasSubstr("'flying'"));
  EXPECT_THAT(errorOf(kHeader + "0,0.0,1,static,1,2,3,4,5m,6,7,8,9,10\n"),
              HasSubstr("column l is no number: '5m'"));
  EXPECT_NE(userErrorOf([&] { readTracksCsv(folder / "none.csv"); }), "");
}

}  // namespace
}  // namespace toss::test
