// SPDX-License-Identifier: BSD-3-Clause
// Runs found by column and by a glance at their keys, against a look at every run.
#include <gtest/gtest.h>
#include <toss/segmentation/RunColumns.h>
#include <toss/segmentation/RunKeys.h>

#include <cmath>
#include <random>

namespace toss::test {
namespace {

constexpr std::int32_t kColumns = 1000;
constexpr int kRows = 4;

/// Runs of random length, gap and range; those of the last row are far beyond what keys tell apart.
RowRuns randomRuns(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> range(1.0f, 60.0f), depth(0.0f, 3.0f);
  std::uniform_int_distribution<std::int32_t> length(0, 6), gap(0, 20);
  RowRuns runs;
  runs.rowBegin.assign(1, 0);
  for (int row = 0; row < kRows; ++row) {
    for (std::int32_t column = gap(random); column < kColumns; column += gap(random)) {
      Run run{};
      run.firstColumn = column;
      column = std::min(column + length(random), kColumns - 1);
      run.lastColumn = column++;
      run.measure.nearest = range(random) + (row == kRows - 1 ? 600.0f : 0.0f);
      run.farthest = run.measure.nearest + depth(random);
      runs.runs.push_back(run);
    }
    runs.rowBegin.push_back(static_cast<std::int32_t>(runs.size()));
  }
  return runs;
}

/// Rules whose surfaces reach 0.5 m.
LinkRules rulesOf() {
  ObjectOptions options;
  options.surfaceDistance = 0.5;
  RangeImage image;
  image.rows = kRows, image.columns = kColumns;
  return LinkRules(options, image);
}

bool reaches(const RowRuns& runs, std::size_t from, std::size_t to, float distance) {
  const Run &one = runs.runs[from], &other = runs.runs[to];
  return other.measure.nearest <= one.farthest + distance &&
         other.farthest >= one.measure.nearest - distance;
}

TEST(RunColumns, FindsEveryRunThatTouchesTheColumns) {
  const RowRuns runs = randomRuns(1);
  RunColumns columns;
  columns.build(runs, kColumns);
  for (int row = 0; row < kRows; ++row) {
    for (std::int32_t left = -30; left < kColumns + 30; left += 7) {
      const std::int32_t right = left + 25;
      const RunColumns::Span found = columns.touching(row, columns.stepsOf(left, right));
      ASSERT_GE(found.begin, runs.rowBegin[static_cast<std::size_t>(row)]);
      ASSERT_LE(found.end, runs.rowBegin[static_cast<std::size_t>(row) + 1]);
      for (auto run = runs.rowBegin[static_cast<std::size_t>(row)];
           run < runs.rowBegin[static_cast<std::size_t>(row) + 1]; ++run) {
        const auto r = static_cast<std::size_t>(run);
        const bool touches = runs.runs[r].firstColumn <= right && runs.runs[r].lastColumn >= left;
        const bool isFound = run >= found.begin && run < found.end;
        EXPECT_TRUE(isFound || !touches) << "row " << row << ", left " << left << ", run " << run;
        const bool near =
            runs.runs[r].firstColumn <= right + 4 && runs.runs[r].lastColumn >= left - 4;
        const bool outside = right < 0 || left >= kColumns;
        EXPECT_TRUE(!isFound || near || outside) << "row " << row << ", left " << left;
      }
    }
  }
}

TEST(RunKeys, TellRunsInReachFromOthers) {
  const RowRuns runs = randomRuns(2);
  const auto count = static_cast<std::int32_t>(runs.size());
  const LinkRules rules = rulesOf();
  RunKeys keys;
  keys.build(runs);
  for (std::int32_t run = 0; run < count; ++run) keys.setSet(run, run % 3);
  std::size_t refused = 0;
  for (std::int32_t a = 0; a < count; a += 5) {
    const auto from = static_cast<std::size_t>(a);
    RunVicinity vicinity;
    RunKeys::setOwnSet(a % 3, vicinity);
    const auto& run = runs[a];
    const float nearest = run.measure.nearest;
    RunKeys::setRanges(nearest, run.farthest, rules.vertical, vicinity);
    RunKeys::setSurface(nearest, run.farthest, rules.surfaceDistance, run.firstColumn,
                        run.lastColumn, vicinity);
    for (std::int32_t b = 0; b < count; ++b) {
      const auto to = static_cast<std::size_t>(b);
      const bool close = reaches(runs, from, to, rules.vertical.at(run.farthest));
      const bool beside =
          runs[b].firstColumn <= run.lastColumn + 1 && runs[b].lastColumn >= run.firstColumn - 1;
      const bool surface = beside && reaches(runs, from, to, 0.5f);
      const bool other = a % 3 != b % 3;
      // Each run in turn by another bit.
      const std::int32_t bit = std::min(b, a % RunKeys::kLanes);
      const bool found = (keys.inVicinity<false>(b - bit, vicinity) >> bit & 1u) != 0;
      const bool foundWithSurface = (keys.inVicinity<true>(b - bit, vicinity) >> bit & 1u) != 0;
      EXPECT_TRUE(found || !(close && other)) << a << " and " << b;
      EXPECT_TRUE(foundWithSurface || !((close || surface) && other)) << a << " and " << b;
      EXPECT_TRUE(other || !foundWithSurface) << a << " and " << b;
      refused += foundWithSurface ? 0 : 1;
    }
  }
  EXPECT_GT(refused, static_cast<std::size_t>(count) * static_cast<std::size_t>(count) / 10);
}

TEST(RunKeys, DoNotTellSetsOfLargeNumbersApart) {
  const RowRuns runs = randomRuns(3);
  const LinkRules rules = rulesOf();
  RunKeys keys;
  keys.build(runs);
  for (const std::int32_t set : {65533, 65534, 65535, 1 << 20}) {
    keys.setSet(0, set);
    const auto found = [&](std::int32_t own) {
      RunVicinity vicinity;
      RunKeys::setOwnSet(own, vicinity);
      RunKeys::setRanges(runs[0].measure.nearest, runs[0].farthest, rules.horizontal, vicinity);
      return (keys.inVicinity<false>(0, vicinity) & 1u) != 0;
    };
    EXPECT_EQ(found(set), set > 65533) << set;
    EXPECT_TRUE(found(set + 1)) << set;
    EXPECT_TRUE(found(7)) << set;
  }
}

}  // namespace
}  // namespace toss::test
