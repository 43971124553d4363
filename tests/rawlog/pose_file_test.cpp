// SPDX-License-Identifier: BSD-3-Clause
#include <InputFixtures.h>
#include <toss/rawlog/PoseFile.h>

namespace toss::test {
namespace {

using ::testing::HasSubstr;

class PoseFileTest : public ::testing::Test {
 protected:
  fs::path write(const std::string& text) {
    writeBytes(folder_ / "poses.txt", text);
    return folder_ / "poses.txt";
  }
  std::string errorOf(const std::string& text) {
    const fs::path file = write(text);
    return userErrorOf([&] { PoseFile{file}; });
  }
  TemporaryFolder folder_;
};

TEST_F(PoseFileTest, InterpolatesTumPosesInTime) {
  // A quarter turn about z from the first pose to the second, which stand in the wrong order.
  const PoseFile file(
      write("# timestamp tx ty tz qx qy qz qw\n\n"
            "10.1 2 0 4 0 0 0.7071067811865476 0.7071067811865476\n10 1 0 0 0 0 0 1\n"));
  EXPECT_EQ(file.format(), PoseFileFormat::Tum);
  ASSERT_EQ(file.times().size(), 2u);
  EXPECT_EQ(file.times()[0], 10.0);
  ASSERT_TRUE(file.at(7, 10.025));
  EXPECT_TRUE(file.at(7, 10.025)->isApprox(poseOf(1.25, 0, 1, M_PI / 8), 1e-9));
  EXPECT_TRUE(file.at(0, 10.1)->isApprox(poseOf(2, 0, 4, M_PI / 2), 1e-12));
  EXPECT_FALSE(file.at(0, 9.99));
  EXPECT_FALSE(file.at(0, 10.11));
}

TEST_F(PoseFileTest, DoesNotInterpolateOverLongGaps) {
  const fs::path path = write("1 0 0 0 0 0 0 1\n2 1 0 0 0 0 0 1\n");
  EXPECT_FALSE(PoseFile(path).at(0, 1.5));
  EXPECT_TRUE(PoseFile(path, 0.6).at(0, 1.5));
}

TEST_F(PoseFileTest, GivesKittiPosesByTheNumberOfTheScan) {
  const PoseFile file(write("1 0 0 0 0 1 0 0 0 0 1 0\n0 -1 0 5 1 0 0 6 0 0 1 7\n"));
  EXPECT_EQ(file.format(), PoseFileFormat::Kitti);
  EXPECT_TRUE(file.at(1, 0.0)->isApprox(poseOf(5, 6, 7, M_PI / 2), 1e-12));
  EXPECT_FALSE(file.at(2, 0.0));
  EXPECT_TRUE(file.times().empty());
}

TEST_F(PoseFileTest, ReadsLinesSeparatedByCommas) {
  const PoseFile file(write("1.5,1,2,3,0,0,0,1\r\n"));
  EXPECT_TRUE(file.at(0, 1.5)->isApprox(poseOf(1, 2, 3, 0)));
}

TEST_F(PoseFileTest, ReadsWhatIsWritten) {
  std::vector<double> times;
  std::vector<Eigen::Isometry3d> poses;
  for (int i = 0; i < 20; ++i) {
    times.push_back(fromMrptTime(toMrptTime(1.6e9 + 0.1 * i)));
    poses.push_back(poseOf(1e5 + 0.1 * i, -3.7 * i, 0.01 * i, 0.3 * i, 0.1, -0.02 * i));
  }
  for (const PoseFileFormat format : {PoseFileFormat::Tum, PoseFileFormat::Kitti}) {
    writePoseFile(folder_ / "out.txt", format, times, poses);
    const PoseFile read(folder_ / "out.txt");
    EXPECT_EQ(read.format(), format);
    for (std::size_t i = 0; i < poses.size(); ++i) {
      const auto pose = read.at(i, times[i]);
      ASSERT_TRUE(pose);
      EXPECT_TRUE(pose->translation() == poses[i].translation());
      EXPECT_LT((pose->linear() - poses[i].linear()).cwiseAbs().maxCoeff(), 1e-14);
    }
  }
}

TEST_F(PoseFileTest, NamesTheLineThatIsWrong) {
  const std::string good = "1 0 0 0 0 0 0 1\n";
  EXPECT_THAT(errorOf(good + "2 0 0 0 0 0 1\n"), HasSubstr("poses.txt: line 2: is no pose"));
  EXPECT_THAT(errorOf(good + "#\n2 a 0 0 0 0 0 1\n"), HasSubstr("line 3: is no pose"));
  EXPECT_THAT(errorOf(good + "2 nan 0 0 0 0 0 1\n"), HasSubstr("line 2: is not finite"));
  EXPECT_THAT(errorOf(good + "2 0 0 0 0 0 0 0\n"), HasSubstr("line 2: its quaternion"));
  EXPECT_THAT(errorOf(good + "1 5 0 0 0 0 0 1\n"), HasSubstr("line 2: has the time of another"));
  EXPECT_THAT(errorOf("1600000000000000000 0 0 0 0 0 0 1\n"), HasSubstr("not nanoseconds"));
  EXPECT_THAT(errorOf("1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0 0 0 1 0 0 0 0 7 0\n"),
              HasSubstr("line 2: is no pose"));
  EXPECT_THAT(errorOf("1 2 3\n"), HasSubstr("line 1: is no pose in TUM"));
  EXPECT_THAT(errorOf("# nothing\n"), HasSubstr("holds no pose"));
  EXPECT_THAT(userErrorOf([&] { PoseFile{folder_ / "none.txt"}; }), HasSubstr("can't be read"));
}

}  // namespace
}  // namespace toss::test
