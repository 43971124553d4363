// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <toss/geometry/Error.h>
#include <toss/segmentation/ObjectSegmentation.h>

#include <stdexcept>

#include "ObjectTestScan.h"

namespace toss {
namespace {

using test::ObjectTestScan;
using test::SceneBox;

void segment(ObjectTestScan& scan, const ObjectOptions& options = ObjectOptions()) {
  ObjectSegmentation(options).segment(scan.points, scan.image, scan.segmentation);
}

/// An upright box of the given footprint centre and size, from the ground 1.7 m below the sensor.
SceneBox standing(double x, double y, double sizeX, double sizeY, double height) {
  return {{x - sizeX / 2, y - sizeY / 2, -1.7}, {x + sizeX / 2, y + sizeY / 2, height - 1.7}};
}

/// The single instance of a box.
std::int32_t onlyInstance(const ObjectTestScan& scan, int box) {
  const std::set<std::int32_t> instances = scan.instancesOf(box);
  EXPECT_EQ(instances.size(), 1u) << "box " << box;
  return instances.empty() ? -1 : *instances.begin();
}

TEST(ObjectSegmentation, KeepsPeopleHalfAMetreApartAndEachInOnePiece) {
  ObjectTestScan scan = ObjectTestScan::hdl64();
  scan.cast({standing(9.0, 0.0, 0.4, 0.5, 1.8), standing(9.0, 1.0, 0.4, 0.5, 1.7)});
  segment(scan);
  const std::int32_t first = onlyInstance(scan, 0), second = onlyInstance(scan, 1);
  EXPECT_GT(first, 0);
  EXPECT_GT(second, 0);
  EXPECT_NE(first, second);
}

TEST(ObjectSegmentation, JoinsACarThatAPoleCuts) {
  ObjectTestScan scan = ObjectTestScan::hdl64();
  scan.cast({standing(10.0, 0.0, 1.8, 4.2, 1.5), standing(7.0, 0.0, 0.1, 0.1, 4.0)});
  segment(scan);
  const std::int32_t car = onlyInstance(scan, 0), pole = onlyInstance(scan, 1);
  EXPECT_GT(car, 0);
  EXPECT_GT(pole, 0);
  EXPECT_NE(car, pole);
}

TEST(ObjectSegmentation, JoinsAnObjectAcrossTheRearSeam) {
  ObjectTestScan scan = ObjectTestScan::hdl64();
  scan.cast({standing(-10.0, 0.0, 1.8, 4.2, 1.5)});
  segment(scan);
  EXPECT_EQ(scan.segmentation.instanceCount, 1);
  EXPECT_EQ(onlyInstance(scan, 0), 1);
}

TEST(ObjectSegmentation, JoinsRowsThatMeetOnlyAcrossTheSeam) {
  ObjectTestScan scan(4, 360, 0.02, -0.02);
  for (int column = 350; column < 360; ++column) scan.add(1, column, 8.0);
  for (int column = 0; column < 10; ++column) scan.add(2, column, 8.0);
  segment(scan);
  EXPECT_EQ(scan.segmentation.instanceCount, 1);
}

TEST(ObjectSegmentation, KeepsFarObjectsInOnePieceWhereBeamsAreSparse) {
  ObjectTestScan scan = ObjectTestScan::hdl64();
  scan.cast({standing(55.0, 0.0, 4.2, 1.8, 1.5)});
  segment(scan);
  EXPECT_EQ(onlyInstance(scan, 0), 1);
}

TEST(ObjectSegmentation, NeverThrowsALargeClusterAway) {
  ObjectTestScan scan = ObjectTestScan::hdl64();
  scan.cast({standing(0.0, 12.0, 60.0, 0.3, 6.0), standing(0.0, -12.0, 60.0, 0.3, 6.0)});
  segment(scan);
  ASSERT_GT(scan.size(), 20000u);
  EXPECT_EQ(scan.instancesOf(0).count(0), 0u);
  EXPECT_EQ(scan.instancesOf(1).count(0), 0u);
}

TEST(ObjectSegmentation, ReferenceBehaviourDropsLargeClusters) {
  ObjectTestScan scan = ObjectTestScan::hdl64();
  scan.cast({standing(0.0, 12.0, 60.0, 0.3, 6.0), standing(8.0, 0.0, 0.5, 0.5, 1.7)});
  ObjectOptions options;
  options.metric = LinkMetric::Constant;
  options.maxPoints = 5000;
  options.attachDistance = options.splitExtent = 0.0;
  segment(scan, options);
  EXPECT_EQ(onlyInstance(scan, 0), 0);
  EXPECT_EQ(onlyInstance(scan, 1), 1);
}

TEST(ObjectSegmentation, CutsAPersonFromALongHedge) {
  // 0.3 m of air between them: within the link distance at 20 m, beyond half of it.
  const std::vector<SceneBox> scene = {standing(0.0, 20.0, 40.0, 0.5, 1.5),
                                       standing(20.5, 19.95, 0.4, 0.4, 1.8)};
  ObjectOptions options;
  for (const bool split : {false, true}) {
    ObjectTestScan scan = ObjectTestScan::hdl64();
    scan.cast(scene);
    options.splitExtent = split ? 6.0 : 0.0;
    segment(scan, options);
    EXPECT_EQ(onlyInstance(scan, 0) != onlyInstance(scan, 1), split);
  }
}

TEST(ObjectSegmentation, KeepsACrumbWithTheTruckItIsSplitFrom) {
  // A mirror 0.15 m from the truck's side: within the link distance, beyond half of it.
  const std::vector<SceneBox> scene = {standing(9.0, 12.0, 12.0, 2.5, 3.8),
                                       {{3.0, 10.4, -0.2}, {3.2, 10.6, 0.1}}};
  ObjectOptions options;
  for (const double splitMinSize : {0.0, 0.3}) {
    ObjectTestScan scan = ObjectTestScan::hdl64();
    scan.cast(scene);
    options.splitMinSize = splitMinSize;
    segment(scan, options);
    const bool together = scan.instancesOf(0) == scan.instancesOf(1);
    EXPECT_EQ(together, splitMinSize > 0.0);
  }
}

TEST(ObjectSegmentation, KeepsABonnetWithItsCar) {
  // Seen from 6 m the rows lie farther apart on the flat bonnet than the link distance.
  ObjectTestScan scan = ObjectTestScan::hdl64();
  const std::vector<SceneBox> car = {standing(8.0, 0.0, 4.2, 1.8, 0.8),
                                     standing(9.0, 0.0, 2.2, 1.8, 1.8)};
  scan.cast(car);
  ObjectOptions options;
  options.surfaceDistance = 0.0;
  segment(scan, options);
  EXPECT_GT(scan.segmentation.instanceCount, 1);
  ObjectTestScan again = ObjectTestScan::hdl64();
  again.cast(car);
  segment(again);
  EXPECT_EQ(again.segmentation.instanceCount, 1);
}

TEST(ObjectSegmentation, NumbersInstancesByFirstPixel) {
  ObjectTestScan scan(4, 360, 0.02, -0.02);
  for (int column = 200; column < 210; ++column) scan.add(0, column, 8.0);
  for (int column = 20; column < 30; ++column) scan.add(1, column, 8.0);
  for (int column = 100; column < 110; ++column) scan.add(1, column, 8.0);
  segment(scan);
  ASSERT_EQ(scan.segmentation.instanceCount, 3);
  EXPECT_EQ(scan.segmentation.instance[0], 1);
  EXPECT_EQ(scan.segmentation.instance[10], 2);
  EXPECT_EQ(scan.segmentation.instance[20], 3);
}

TEST(ObjectSegmentation, TakesAScanWithoutAnyReturn) {
  ObjectTestScan scan = ObjectTestScan::hdl64();
  segment(scan);
  EXPECT_EQ(scan.segmentation.instanceCount, 0);
  EXPECT_EQ(scan.segmentation.memberBegin, std::vector<std::int32_t>{0});
  EXPECT_TRUE(scan.segmentation.members.empty());
}

TEST(ObjectSegmentation, TakesAnImageOfOneRow) {
  ObjectTestScan scan(2, 360, 0.02, -0.02);
  for (int column = 0; column < 20; ++column) scan.add(0, column, 5.0);
  scan.image.rows = 1;
  scan.image.representative.resize(360);
  scan.image.elevations.resize(1);
  segment(scan);
  EXPECT_EQ(scan.segmentation.instanceCount, 1);
}

TEST(ObjectSegmentation, RefusesArraysOfDifferentScans) {
  ObjectTestScan scan(4, 360, 0.02, -0.02);
  scan.add(0, 0, 5.0);
  scan.points.z.clear();
  EXPECT_THROW(segment(scan), std::logic_error);
}

TEST(ObjectSegmentation, RefusesOptionsOutOfRange) {
  ObjectOptions options;
  options.rowWindow = 0;
  EXPECT_THROW(ObjectSegmentation{options}, UserError);
}

}  // namespace
}  // namespace toss
