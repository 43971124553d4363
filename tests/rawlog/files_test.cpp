// SPDX-License-Identifier: BSD-3-Clause
// Files that appear only when complete, and label files.
#include <InputFixtures.h>
#include <toss/rawlog/AtomicFile.h>
#include <toss/rawlog/LabelFile.h>

#include <stdexcept>

namespace toss::test {
namespace {

using ::testing::HasSubstr;

TEST(AtomicFile, AppearsOnCommitOnly) {
  TemporaryFolder folder;
  const fs::path path = folder / "map.ply";
  writeBytes(path, "old");
  {
    AtomicFile file(path);
    EXPECT_EQ(file.temporaryPath().extension(), ".ply");
    EXPECT_EQ(file.temporaryPath().parent_path(), path.parent_path());
    writeBytes(file.temporaryPath(), "new");
    EXPECT_EQ(readBytes(path), "old");
    file.commit();
    EXPECT_EQ(readBytes(path), "new");
  }
  EXPECT_EQ(readBytes(path), "new");
}

TEST(AtomicFile, LeavesNothingWhenWritingFails) {
  TemporaryFolder folder;
  const fs::path path = folder / "map.ply";
  EXPECT_THROW(writeAtomically(path,
                               [](const fs::path& file) {
                                 writeBytes(file, "half");
                                 throw std::runtime_error("stop");
                               }),
               std::runtime_error);
  EXPECT_TRUE(fs::is_empty(path.parent_path()));
}

TEST(AtomicFile, RefusesPathsThatCanNotBeFiles) {
  TemporaryFolder folder;
  EXPECT_THAT(userErrorOf([&] { AtomicFile(folder / "nowhere/map.ply"); }),
              HasSubstr("its folder does not exist"));
  EXPECT_THAT(userErrorOf([&] { AtomicFile(folder / ""); }), HasSubstr("is no file name"));
  fs::create_directories(folder / "map.ply");
  EXPECT_THAT(userErrorOf([&] { AtomicFile(folder / "map.ply"); }), HasSubstr("is a folder"));
}

TEST(LabelFile, ReadsWhatItWrote) {
  TemporaryFolder folder;
  const fs::path file = labelPath(folder / "", 7);
  EXPECT_EQ(file.filename(), "000007.label");
  const std::vector<std::uint32_t> labels = {0, 9, label::kMoving | 5u << 16, 0xffffffffu};
  writeLabels(file, labels);
  EXPECT_EQ(fs::file_size(file), 16u);
  EXPECT_EQ(readLabels(file, 4), labels);
  EXPECT_EQ(label::instance(labels[2]), 5u);
  EXPECT_TRUE(label::isMoving(labels[2]));
}

TEST(LabelFile, RefusesLabelsOfAnotherScan) {
  TemporaryFolder folder;
  writeBytes(folder / "a.label", std::string(10, 'x'));
  EXPECT_THAT(userErrorOf([&] { readLabels(folder / "a.label", 2); }), HasSubstr("10 bytes"));
  EXPECT_THAT(userErrorOf([&] { readLabels(folder / "b.label", 2); }), HasSubstr("can't be read"));
  EXPECT_THAT(userErrorOf([&] { writeLabels(folder / "none/b.label", {1}); }),
              HasSubstr("folder does not exist"));
}

TEST(LabelsFolder, LiesBesideTheInput) {
  TemporaryFolder folder;
  EXPECT_EQ(labelsFolderBeside("logs/a.rawlog"), "logs/a_labels");
  EXPECT_EQ(labelsFolderBeside("a.rawlog.gz"), "a_labels");
  EXPECT_EQ(labelsFolderOf(folder / "a.rawlog"), fs::path());
  fs::create_directories(folder / "a_labels");
  EXPECT_EQ(labelsFolderOf(folder / "a.rawlog"), folder / "a_labels");
}

}  // namespace
}  // namespace toss::test
