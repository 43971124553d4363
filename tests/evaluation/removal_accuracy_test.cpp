// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <toss/evaluation/RemovalAccuracy.h>

#include <cmath>

#include "BruteForce.h"

namespace toss::test {
namespace {

constexpr double kRemovalDistance = 0.05;

struct LabelledScan {
  LabelledCloud cloud;
  std::vector<std::uint16_t> kept;
};

std::vector<LabelledScan> randomScans(unsigned seed) {
  std::mt19937 random(seed);
  std::vector<LabelledScan> scans(3);
  for (LabelledScan& scan : scans) {
    scan.cloud = randomCloud(random, 150, 0.4, 0.01);
    for (std::size_t i = 0; i < scan.cloud.size(); ++i) scan.kept.push_back(random() % 4 == 0);
  }
  return scans;
}

RemovalAccuracy byTryingAll(const std::vector<LabelledScan>& scans) {
  LabelledCloud output;
  for (const LabelledScan& scan : scans) {
    for (std::size_t i = 0; i < scan.cloud.size(); ++i) {
      if (scan.kept[i]) output.add(scan.cloud.x[i], scan.cloud.y[i], scan.cloud.z[i], 0);
    }
  }
  RemovalAccuracy result;
  for (const LabelledScan& scan : scans) {
    for (std::size_t i = 0; i < scan.cloud.size(); ++i) {
      bool near = false;
      for (std::size_t j = 0; j < output.size(); ++j) {
        near |= distanceSquared(scan.cloud, i, output, j) <= kRemovalDistance * kRemovalDistance;
      }
      const bool moving = scan.cloud.label[i] != 9u;
      ++(moving ? result.movingPoints : result.staticPoints);
      result.staticKept += !moving && near, result.movingRemoved += moving && !near;
    }
  }
  return result;
}

void expectEqual(const RemovalAccuracy& a, const RemovalAccuracy& b) {
  EXPECT_EQ(a.staticPoints, b.staticPoints);
  EXPECT_EQ(a.staticKept, b.staticKept);
  EXPECT_EQ(a.movingPoints, b.movingPoints);
  EXPECT_EQ(a.movingRemoved, b.movingRemoved);
}

RemovalAccuracy ofLabels(const std::vector<LabelledScan>& scans) {
  LabelRemovalAccuracy accuracy(kRemovalDistance, 0.2);
  for (const LabelledScan& scan : scans) {
    for (std::size_t i = 0; i < scan.cloud.size(); ++i) {
      accuracy.add(scan.cloud.x[i], scan.cloud.y[i], scan.cloud.z[i], scan.cloud.label[i] != 9u,
                   scan.kept[i] != 0);
    }
  }
  accuracy.endFirstPass();
  for (const LabelledScan& scan : scans) {
    CellOrder order, kept;
    orderByCell(scan.cloud, 0.2, order);
    selectMembers(order, scan.kept, 1, kept);
    accuracy.addKept(kept);
  }
  return accuracy.result();
}

class RandomRemoval : public testing::TestWithParam<unsigned> {};

TEST_P(RandomRemoval, OfLabelsEqualsTryingAll) {
  const std::vector<LabelledScan> scans = randomScans(GetParam());
  expectEqual(ofLabels(scans), byTryingAll(scans));
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomRemoval, testing::Range(0u, 10u));

TEST(RemovalAccuracy, TakesBothMeans) {
  RemovalAccuracy accuracy;
  accuracy.staticPoints = 100, accuracy.staticKept = 80;
  accuracy.movingPoints = 10, accuracy.movingRemoved = 2;
  EXPECT_DOUBLE_EQ(accuracy.staticAccuracy(), 80.0);
  EXPECT_DOUBLE_EQ(accuracy.dynamicAccuracy(), 20.0);
  EXPECT_DOUBLE_EQ(accuracy.associatedAccuracy(), 40.0);
  EXPECT_DOUBLE_EQ(accuracy.harmonicAccuracy(), 32.0);
}

TEST(RemovalAccuracy, IsUndefinedWithoutPointsOfTheKind) {
  RemovalAccuracy accuracy;
  accuracy.add(false, true);
  EXPECT_TRUE(std::isnan(accuracy.dynamicAccuracy()));
  EXPECT_TRUE(std::isnan(accuracy.associatedAccuracy()));
  EXPECT_DOUBLE_EQ(accuracy.staticAccuracy(), 100.0);
}

}  // namespace
}  // namespace toss::test
