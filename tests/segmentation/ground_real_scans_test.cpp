// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <toss/segmentation/GroundSegmentation.h>
#include <toss/segmentation/LevelFrame.h>
#include <toss/segmentation/RangeImageProjection.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <map>

#include "RealScans.h"

namespace toss::test {
namespace {

/// One after the other through projection and ground, with the options for the recording car.
class GroundOfRealScans : public testing::Test {
 protected:
  RangeImage image;
  LevelPoints level;
  Segmentation segmentation;

  void run(const PointCloud& points, const Eigen::Isometry3d& mapFromSensor) {
    projection_.project(points, image, segmentation.pointClass);
    toLevelFrame(points, mapFromSensor, level);
    ground_.segment(level, image, segmentation);
  }
  bool isGround(std::size_t i) const { return segmentation.pointClass[i] == PointClass::Ground; }
  bool takesPart(std::size_t i) const { return image.row[i] != RangeImage::kNoRow; }

 private:
  static ProjectionOptions ofTheCar() {
    ProjectionOptions options;
    options.egoRadius = 2.7;
    return options;
  }
  RangeImageProjection projection_{ofTheCar(), sensorByName("HDL-64E")};
  GroundSegmentation ground_{GroundOptions{}};
};

struct Share {
  int hits = 0, count = 0;
  void add(bool hit) { hits += hit, ++count; }
  double value() const { return count == 0 ? 0.0 : static_cast<double>(hits) / count; }
};

TEST_F(GroundOfRealScans, TakesTheRoadAndLeavesTheMovers) {
  TOSS_NEED_REAL_DATA(KittiSequence::folder());
  const KittiSequence sequence;
  Share lowAndNear, movers, standingCars, all, below;
  for (std::size_t scan = 0; scan < sequence.size(); scan += 11) {
    const PointCloud points = sequence.points(scan);
    const std::vector<std::uint32_t> labels = sequence.labels(scan);
    run(points, sequence.mapFromSensor(scan));
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (!takesPart(i)) continue;
      const std::uint32_t label = labels[i] & 0xFFFFu;
      all.add(isGround(i));
      below.add(segmentation.pointClass[i] == PointClass::BelowGround);
      if (std::hypot(points.x[i], points.y[i]) < 20.0f && level.z[i] < -1.5f) {
        lowAndNear.add(isGround(i));
      }
      if (label >= 252 && label <= 254) movers.add(isGround(i));
      if (label == 10) standingCars.add(isGround(i));
    }
  }
  std::printf("ground: %.3f of all, %.3f of low and near returns, %.4f of movers, %.4f of cars\n",
              all.value(), lowAndNear.value(), movers.value(), standingCars.value());
  ASSERT_GT(movers.count, 5000);
  EXPECT_GT(lowAndNear.value(), 0.95);
  EXPECT_LT(movers.value(), 0.005);
  EXPECT_LT(standingCars.value(), 0.005);
  EXPECT_LT(below.value(), 0.002);
}

TEST_F(GroundOfRealScans, AgreesWithAnAnnotatorPointByPoint) {
  const std::filesystem::path folder = realDataFolder() / "semantickitti-one-scan";
  TOSS_NEED_REAL_DATA(folder);
  std::filesystem::path scan, truth;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.path().extension() == ".bin") scan = entry.path();
    if (entry.path().extension() == ".label") truth = entry.path();
  }
  const PointCloud points = readVelodyneBin(scan);
  const std::vector<std::uint32_t> labels = readBinary<std::uint32_t>(truth);
  run(points, Eigen::Isometry3d::Identity());

  std::map<std::uint32_t, Share> ground;
  Share heightWithin5cm;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!takesPart(i)) continue;
    const std::uint32_t label = labels[i] & 0xFFFFu;
    ground[label].add(isGround(i));
    const bool road = label == 40 || label == 48;
    if (road && image.range[i] < 30.0f) {
      heightWithin5cm.add(std::fabs(segmentation.heightAboveGround[i]) < 0.05f);
    }
  }
  EXPECT_GT(ground[40].value(), 0.98) << "road";
  EXPECT_GT(ground[48].value(), 0.98) << "pavement";
  EXPECT_GT(ground[72].value(), 0.90) << "terrain";
  EXPECT_LT(ground[50].value(), 0.20) << "buildings";
  EXPECT_LT(ground[10].value(), 0.02) << "standing cars";
  EXPECT_LT(ground[252].value(), 0.03) << "moving cars";
  EXPECT_LT(ground[254].value(), 0.05) << "moving people";
  EXPECT_GT(heightWithin5cm.value(), 0.93);
}

TEST_F(GroundOfRealScans, IsTheSameTwice) {
  TOSS_NEED_REAL_DATA(KittiSequence::folder());
  const KittiSequence sequence;
  run(sequence.points(5), sequence.mapFromSensor(5));
  const std::vector<PointClass> first = segmentation.pointClass;
  run(sequence.points(60), sequence.mapFromSensor(60));
  run(sequence.points(5), sequence.mapFromSensor(5));
  EXPECT_EQ(segmentation.pointClass, first) << "nothing may be left over from the scan before";
}

}  // namespace
}  // namespace toss::test
