// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <toss/render/PointSample.h>

#include <algorithm>

namespace toss {
namespace {

MapPoint numbered(std::size_t i) {
  return {static_cast<float>(i), 0.0f, 0.0f, 0.0f};
}

PointSample sampleOf(std::size_t count, std::size_t limit) {
  PointSample sample(limit);
  for (std::size_t i = 0; i < count; ++i) sample.add(numbered(i));
  return sample;
}

TEST(PointSampleTest, KeepsEverythingWithinTheLimit) {
  const PointSample sample = sampleOf(1000, 1000);
  ASSERT_EQ(sample.points().size(), 1000u);
  for (std::size_t i = 0; i < 1000; ++i) EXPECT_EQ(sample.points()[i].x, static_cast<float>(i));
}

TEST(PointSampleTest, KeepsAnEvenShareBeyondIt) {
  const PointSample sample = sampleOf(100000, 4000);
  EXPECT_EQ(sample.seen(), 100000u);
  EXPECT_LE(sample.points().size(), 4000u);
  EXPECT_GE(sample.points().size(), 1500u);
  // Every tenth of the input has its tenth of the sample: four standard deviations are 20 %.
  const double share = static_cast<double>(sample.points().size()) / 10.0;
  for (int tenth = 0; tenth < 10; ++tenth) {
    const auto inside =
        std::count_if(sample.points().begin(), sample.points().end(),
                      [&](const MapPoint& p) { return static_cast<int>(p.x) / 10000 == tenth; });
    EXPECT_NEAR(static_cast<double>(inside), share, 0.25 * share);
  }
}

TEST(PointSampleTest, IsTheSameEachTime) {
  const auto a = sampleOf(50000, 1000), b = sampleOf(50000, 1000);
  ASSERT_EQ(a.points().size(), b.points().size());
  for (std::size_t i = 0; i < a.points().size(); ++i) EXPECT_EQ(a.points()[i].x, b.points()[i].x);
}

TEST(PointSampleTest, IndicesAreAscendingAndLimited) {
  EXPECT_EQ(sampleIndices(5, 5), (std::vector<std::uint32_t>{0, 1, 2, 3, 4}));
  EXPECT_TRUE(sampleIndices(0, 5).empty());
  const auto indices = sampleIndices(100000, 1000);
  EXPECT_LE(indices.size(), 1000u);
  EXPECT_GE(indices.size(), 850u);
  EXPECT_TRUE(std::is_sorted(indices.begin(), indices.end()));
  EXPECT_EQ(std::adjacent_find(indices.begin(), indices.end()), indices.end());
}

}  // namespace
}  // namespace toss
