// SPDX-License-Identifier: BSD-3-Clause
// Every return gets an instance or stays what it was; none is lost (spec section 11).
#include <gtest/gtest.h>
#include <toss/segmentation/ObjectSegmentation.h>

#include <random>

#include "ObjectTestScan.h"

namespace toss {
namespace {

using test::ObjectTestScan;

void segment(ObjectTestScan& scan, const ObjectOptions& options = ObjectOptions()) {
  ObjectSegmentation(options).segment(scan.points, scan.image, scan.segmentation);
}

/// Blobs of returns all around with lone returns in between, some of other classes.
ObjectTestScan clutter(unsigned seed) {
  ObjectTestScan scan(16, 240, 0.05, -0.25);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int row = 0; row < scan.image.rows; ++row) {
    for (int column = 0; column < scan.image.columns; ++column) {
      const bool blob = (column / 12) % 2 == 0 && row > 3;
      if (uniform(random) > (blob ? 0.8 : 0.15)) continue;
      const double range = blob ? 6.0 + (column / 12) * 0.7 : 5.0 + 20.0 * uniform(random);
      scan.add(row, column, range + 0.4 * uniform(random));
      if (uniform(random) < 0.15) scan.add(row, column, range + 1.5 * uniform(random));
    }
  }
  const PointClass others[] = {PointClass::Ground, PointClass::BelowGround};
  for (std::size_t i = 0; i < scan.size(); i += 17) {
    scan.segmentation.pointClass[i] = others[i % 2];
  }
  return scan;
}

/// Instance of each point by `members`, which must ascend within each instance.
std::vector<std::int32_t> instancesByMembers(const Segmentation& result) {
  std::vector<std::int32_t> instance(result.pointClass.size(), 0);
  for (std::size_t k = 0; k + 1 < result.memberBegin.size(); ++k) {
    const auto begin = result.members.begin() + result.memberBegin[k];
    const auto end = result.members.begin() + result.memberBegin[k + 1];
    EXPECT_LT(begin, end);
    EXPECT_TRUE(std::is_sorted(begin, end));
    for (auto m = begin; m != end; ++m) {
      instance[static_cast<std::size_t>(*m)] = static_cast<std::int32_t>(k) + 1;
    }
  }
  return instance;
}

TEST(ObjectCoverage, ClassesInstancesAndMembersAgree) {
  for (unsigned seed = 0; seed < 5; ++seed) {
    ObjectTestScan scan = clutter(seed);
    const std::vector<PointClass> before = scan.segmentation.pointClass;
    segment(scan);
    const Segmentation& result = scan.segmentation;
    ASSERT_EQ(result.memberBegin.size(), static_cast<std::size_t>(result.instanceCount) + 1);
    EXPECT_EQ(instancesByMembers(result), result.instance);
    ASSERT_EQ(result.pointClass.size(), before.size());
    for (std::size_t i = 0; i < before.size(); ++i) {
      const bool taken = result.instance[i] > 0;
      ASSERT_TRUE(!taken || before[i] == PointClass::Unclustered);
      ASSERT_EQ(result.pointClass[i], taken ? PointClass::Instance : before[i]);
    }
  }
}

/// Instances of the scan when leftovers go to the nearest clustered return, by looking at them all.
std::vector<std::int32_t> attachByBruteForce(const ObjectTestScan& clustered, float distance) {
  std::vector<std::int32_t> result = clustered.segmentation.instance;
  const LevelPoints& p = clustered.points;
  for (std::size_t i = 0; i < result.size(); ++i) {
    if (clustered.segmentation.pointClass[i] != PointClass::Unclustered) continue;
    float nearest = distance * distance;
    for (std::size_t j = 0; j < result.size(); ++j) {
      const float dx = p.x[i] - p.x[j], dy = p.y[i] - p.y[j], dz = p.z[i] - p.z[j];
      const float distance2 = dx * dx + dy * dy + dz * dz;
      if (clustered.segmentation.instance[j] == 0 || distance2 >= nearest) continue;
      nearest = distance2;
      result[i] = clustered.segmentation.instance[j];
    }
  }
  return result;
}

TEST(ObjectCoverage, LeftoversJoinTheNearestInstanceInReach) {
  ObjectOptions options;
  // Every return a node of its own, so that brute force needs no notion of mates.
  options.pixelMerge = 0.0;
  options.minPointsNear = 10, options.minPointsFar = 3;
  for (unsigned seed = 0; seed < 5; ++seed) {
    ObjectTestScan clustered = clutter(seed), attached = clutter(seed);
    options.attachDistance = 0.0;
    segment(clustered, options);
    options.attachDistance = 1.5;
    segment(attached, options);
    const auto expected = attachByBruteForce(clustered, 1.5f);
    ASSERT_NE(expected, clustered.segmentation.instance);
    EXPECT_EQ(attached.segmentation.instance, expected);
  }
}

TEST(ObjectCoverage, MatesOfAPixelShareItsInstanceAndSurfacesBehindDoNot) {
  ObjectTestScan scan(6, 360, 0.02, -0.08);
  for (int row = 0; row < 6; ++row) {
    for (int column = 100; column < 110; ++column) {
      scan.add(row, column, 8.0);
      scan.add(row, column, 8.2);
      scan.add(row, column, 12.0);
    }
  }
  segment(scan);
  EXPECT_EQ(scan.segmentation.instanceCount, 2);
  for (std::size_t i = 0; i < scan.size(); i += 3) {
    ASSERT_EQ(scan.segmentation.instance[i], 1);
    ASSERT_EQ(scan.segmentation.instance[i + 1], 1);
    ASSERT_EQ(scan.segmentation.instance[i + 2], 2);
  }
}

TEST(ObjectCoverage, SeesAnObjectInThePixelsOfGround) {
  ObjectTestScan scan(6, 360, 0.02, -0.08);
  for (int column = 100; column < 112; ++column) {
    scan.add(2, column, 8.0);
    scan.segmentation.pointClass.back() = PointClass::Ground;
    scan.add(2, column, 9.0);
  }
  segment(scan);
  EXPECT_EQ(scan.segmentation.instanceCount, 1);
  EXPECT_EQ(scan.segmentation.instance[0], 0);
  EXPECT_EQ(scan.segmentation.instance[1], 1);
}

TEST(ObjectCoverage, FewReturnsAreAnInstanceFarOutAndNotNearBy) {
  ObjectOptions options;
  options.minPointsNear = 10, options.minPointsFar = 3;
  for (const bool far : {false, true}) {
    ObjectTestScan scan = ObjectTestScan::hdl64();
    for (int column = 100; column < 103; ++column) scan.add(5, column, far ? 45.0 : 6.0);
    segment(scan, options);
    EXPECT_EQ(scan.segmentation.instanceCount, far ? 1 : 0);
    const PointClass expected = far ? PointClass::Instance : PointClass::Unclustered;
    EXPECT_EQ(scan.segmentation.pointClass[0], expected);
  }
}

TEST(ObjectCoverage, ReturnsThatAreNotNumbersStayWithoutInstance) {
  ObjectTestScan scan(4, 360, 0.02, -0.02);
  for (int column = 0; column < 20; ++column) scan.add(1, column, 8.0);
  scan.points.x[10] = std::numeric_limits<float>::quiet_NaN();
  segment(scan);
  EXPECT_EQ(scan.segmentation.instance[10], 0);
  EXPECT_EQ(scan.segmentation.instance[9], 1);
  EXPECT_EQ(scan.segmentation.instance[11], 1);
}

TEST(ObjectCoverage, TheSameScanGivesTheSameResultAfterOthers) {
  ObjectSegmentation objects{ObjectOptions()};
  ObjectTestScan first = clutter(1), other = clutter(2), again = clutter(1);
  objects.segment(first.points, first.image, first.segmentation);
  objects.segment(other.points, other.image, other.segmentation);
  objects.segment(again.points, again.image, again.segmentation);
  EXPECT_EQ(first.segmentation.instance, again.segmentation.instance);
  EXPECT_EQ(first.segmentation.members, again.segmentation.members);
}

}  // namespace
}  // namespace toss
