// SPDX-License-Identifier: BSD-3-Clause
// Marks visited by their bits, against a look at every mark.
#include <gtest/gtest.h>
#include <toss/geometry/MarkedWords.h>

#include <random>
#include <vector>

namespace toss::test {
namespace {

std::vector<std::size_t> visited(const std::vector<std::uint8_t>& marks) {
  std::vector<std::size_t> indices;
  visitMarks(marks.data(), marks.size(), [&](std::size_t i) { indices.push_back(i); });
  return indices;
}

TEST(MarkedWords, VisitsEveryMarkOnceAndInOrder) {
  std::mt19937 random(1);
  for (const double share : {0.0, 0.02, 0.5, 0.98, 1.0}) {
    std::bernoulli_distribution marked(share);
    std::vector<std::uint8_t> marks(roundedToBlocks(1000), 0);
    std::vector<std::size_t> expected;
    for (std::size_t i = 0; i < marks.size(); ++i) {
      marks[i] = marked(random) ? 1 : 0;
      if (marks[i] != 0) expected.push_back(i);
    }
    EXPECT_EQ(visited(marks), expected) << share;
  }
}

TEST(MarkedWords, RoundsLengthsUpToBlocks) {
  EXPECT_EQ(roundedToBlocks(0), 0u);
  EXPECT_EQ(roundedToBlocks(1), kMarksInBlock);
  EXPECT_EQ(roundedToBlocks(kMarksInBlock), kMarksInBlock);
  EXPECT_EQ(roundedToBlocks(kMarksInBlock + 1), 2 * kMarksInBlock);
}

}  // namespace
}  // namespace toss::test
