// SPDX-License-Identifier: BSD-3-Clause
// Rawlogs that are damaged, or no rawlogs: one clear line each, never a crash, never a silent loss.
#include <InputFixtures.h>
#include <zlib.h>

namespace toss::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

class DamagedRawlog : public ::testing::Test {
 protected:
  void SetUp() override {
    writeObjects(folder / "plain.rawlog", logOf(5));
    writeObjects(folder / "gz.rawlog", logOf(5), true);
    plain = readBytes(folder / "plain.rawlog");
    gz = readBytes(folder / "gz.rawlog");
  }

  /// What reading a file of these bytes ends with; `delivered` scans come before.
  std::string errorOf(const std::string& bytes) {
    const fs::path file = folder / "damaged.rawlog";
    writeBytes(file, bytes);
    delivered = 0;
    return userErrorOf([&] {
      const auto source = openScans(file, {});
      PosedScan scan;
      for (; source->next(scan); ++delivered) expectSameScan(scan, makeScan(delivered));
    });
  }

  TemporaryFolder folder;
  std::string plain, gz;
  std::size_t delivered = 0;
};

TEST_F(DamagedRawlog, MissingEmptyTextOrFolder) {
  EXPECT_THAT(userErrorOf([&] { openScans(folder / "nowhere.rawlog", {}); }),
              HasSubstr("nowhere.rawlog: does not exist"));
  EXPECT_THAT(errorOf(""), HasSubstr("is empty"));
  EXPECT_THAT(errorOf("just some text\n"), HasSubstr("is not a rawlog"));
  EXPECT_THAT(errorOf(std::string("\x94\0\1\2\3 random", 12)), HasSubstr("is not a rawlog"));
  fs::create_directories(folder / "folder");
  EXPECT_THAT(userErrorOf([&] { openScans(folder / "folder", {}); }), HasSubstr("velodyne/"));
}

TEST_F(DamagedRawlog, PlainFileCutAnywhere) {
  const std::size_t object = plain.size() / 10;
  for (std::size_t cut = plain.size() - 1; cut > plain.size() - 3 * object; cut -= 37) {
    SCOPED_TRACE(cut);
    const std::string error = errorOf(plain.substr(0, cut));
    // A cut between two objects can't be told from the end.
    if (error.empty()) continue;
    EXPECT_THAT(error, AllOf(HasSubstr("damaged.rawlog: object "), HasSubstr("cut off"),
                             HasSubstr("scans lie before it")));
    EXPECT_GE(delivered, 3u);
  }
}

TEST_F(DamagedRawlog, NamesTheObjectThatIsCut) {
  const std::string error = errorOf(plain.substr(0, plain.size() - 10));
  EXPECT_THAT(error, HasSubstr("object 9 (mrpt::obs::CObservationPointCloud)"));
  EXPECT_THAT(error, HasSubstr("4 scans lie before it"));
  EXPECT_EQ(delivered, 4u);
}

TEST_F(DamagedRawlog, GzCutAnywhere) {
  for (const std::size_t missing :
       std::vector<std::size_t>{1, 4, 8, 9, 50, 100, 500, gz.size() / 2, gz.size() - 30}) {
    SCOPED_TRACE(missing);
    EXPECT_THAT(errorOf(gz.substr(0, gz.size() - missing)), HasSubstr("gz data is cut off"));
  }
}

TEST_F(DamagedRawlog, GzWithWrongChecksum) {
  std::string bytes = gz;
  bytes[bytes.size() - 6] = static_cast<char>(bytes[bytes.size() - 6] ^ 1);
  EXPECT_THAT(errorOf(bytes), HasSubstr("incorrect data check"));
  EXPECT_EQ(delivered, 5u);
}

TEST_F(DamagedRawlog, FlippedBitsInGzAlwaysShow) {
  for (std::size_t at = 40; at < gz.size(); at += gz.size() / 60) {
    SCOPED_TRACE(at);
    std::string bytes = gz;
    bytes[at] = static_cast<char>(bytes[at] ^ 0x10);
    const fs::path file = folder / "damaged.rawlog";
    writeBytes(file, bytes);
    EXPECT_FALSE(userErrorOf([&] { readInput(file); }).empty());
  }
}

TEST_F(DamagedRawlog, FlippedBitsInPlainFilesDoNotCrash) {
  // What changes a number can't be seen; what changes the structure must end in a UserError.
  for (std::size_t at = 0; at < plain.size(); at += 11) {
    SCOPED_TRACE(at);
    std::string bytes = plain;
    bytes[at] = static_cast<char>(bytes[at] ^ 0x04);
    const fs::path file = folder / "damaged.rawlog";
    writeBytes(file, bytes);
    userErrorOf([&] { readInput(file); });
  }
}

TEST_F(DamagedRawlog, ImpossibleNumberOfPointsTakesNoMemory) {
  const std::string pointsMap = "mrpt::maps::CPointsMapXYZI";
  // The number of points follows the class name and its version.
  const std::size_t number = plain.find(pointsMap) + pointsMap.size() + 1;
  std::uint32_t points = 0;
  std::memcpy(&points, plain.data() + number, sizeof points);
  ASSERT_EQ(points, 50u);
  for (const int top : {0x01, 0x40, 0xff}) {
    std::string bytes = plain;
    bytes[number + 3] = static_cast<char>(top);
    EXPECT_THAT(errorOf(bytes), HasSubstr("points, more than the rest of the file can hold"));
  }
}

TEST_F(DamagedRawlog, TrailingGarbage) {
  EXPECT_THAT(errorOf(plain + "garbage"), HasSubstr("no MRPT object"));
  EXPECT_EQ(delivered, 5u);
  EXPECT_THAT(errorOf(gz + "garbage"), HasSubstr("not gz data follows"));
  EXPECT_EQ(delivered, 5u);
}

TEST_F(DamagedRawlog, UnknownClassIsNamed) {
  const std::string name = "vendor::CObservationOfOurOwn";
  std::string object(1, static_cast<char>(0x80 | name.size()));
  object += name + std::string("\0\0\x88", 3);
  EXPECT_THAT(errorOf(plain + object + plain), AllOf(HasSubstr("object 10"), HasSubstr(name)));
  EXPECT_EQ(delivered, 5u);
}

TEST_F(DamagedRawlog, GzOfNothing) {
  writeObjects(folder / "nothing.rawlog", {}, true);
  EXPECT_THAT(userErrorOf([&] { readInput(folder / "nothing.rawlog"); }),
              HasSubstr("is not a rawlog"));
}

}  // namespace
}  // namespace toss::test
