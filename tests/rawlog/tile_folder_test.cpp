// SPDX-License-Identifier: BSD-3-Clause
#include <toss/rawlog/TileFolder.h>

#include "InputFixtures.h"

namespace toss::test {
namespace {

namespace fs = std::filesystem;

std::size_t entriesOf(const fs::path& folder) {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST(TileFolderTest, GivesBackWhatWasStoredLastAndLeavesNothing) {
  const TemporaryFolder folder;
  {
    TileFolder tiles(folder / "tiles");
    EXPECT_EQ(entriesOf(folder / "."), 0u);
    tiles.store(7, {1, 2, 3});
    tiles.store(8, {});
    tiles.store(7, {4, 5});
    std::vector<std::uint8_t> bytes = {9, 9, 9};
    tiles.load(7, bytes);
    EXPECT_EQ(bytes, (std::vector<std::uint8_t>{4, 5}));
    tiles.load(8, bytes);
    EXPECT_TRUE(bytes.empty());
    EXPECT_EQ(entriesOf(folder / "."), 1u);
  }
  EXPECT_EQ(entriesOf(folder / "."), 0u);
}

TEST(TileFolderTest, LostTilesAreTheUsersError) {
  const TemporaryFolder folder;
  TileFolder tiles(folder / "tiles");
  tiles.store(1, {1});
  for (const auto& entry : fs::recursive_directory_iterator(folder / "."))
    if (entry.is_regular_file()) fs::remove(entry.path());
  std::vector<std::uint8_t> bytes;
  EXPECT_THAT(userErrorOf([&] { tiles.load(1, bytes); }), ::testing::HasSubstr("1.tile"));
}

}  // namespace
}  // namespace toss::test
