// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <toss/segmentation/ContactPoints.h>

namespace toss::test {
namespace {

using C = PointClass;

/// One column of beams, topmost first, at 10 m and beyond.
struct Column {
  LevelPoints points;
  RangeImage image;
  Segmentation segmentation;

  Column() {
    image.rows = 5, image.columns = 8;
    image.representative.assign(image.pixel(5, 0), RangeImage::kNone);
  }

  void add(int row, int column, float x, float height, PointClass pointClass) {
    image.representative[image.pixel(row, column)] = static_cast<std::int32_t>(points.x.size());
    image.row.push_back(static_cast<std::uint16_t>(row));
    image.column.push_back(static_cast<std::uint16_t>(column));
    points.x.push_back(x), points.y.push_back(0.0f), points.z.push_back(height - 1.7f);
    segmentation.pointClass.push_back(pointClass);
    segmentation.heightAboveGround.push_back(height);
  }

  std::vector<PointClass> release(double slope = 1.0) {
    GroundOptions options;
    options.contactHeight = 0.03, options.contactSlope = slope;
    ContactPoints().release(points, image, options, segmentation);
    return segmentation.pointClass;
  }
};

/// A leg from 0.3 m down to the ground, and road before it.
Column leg() {
  Column column;
  column.add(0, 3, 10.0f, 0.30f, C::Unclustered);
  column.add(1, 3, 10.0f, 0.09f, C::Ground);
  column.add(2, 3, 10.0f, 0.05f, C::Ground);
  column.add(3, 3, 10.0f, 0.01f, C::Ground);
  column.add(4, 3, 9.4f, 0.04f, C::Ground);
  return column;
}

TEST(ContactPoints, AFootGoesBackToItsLegBeamByBeam) {
  EXPECT_THAT(leg().release(), testing::ElementsAre(C::Unclustered, C::Unclustered, C::Unclustered,
                                                    C::Ground, C::Ground));
}

TEST(ContactPoints, ASlopeOfZeroLeavesAllGround) {
  EXPECT_THAT(leg().release(0.0),
              testing::ElementsAre(C::Unclustered, C::Ground, C::Ground, C::Ground, C::Ground));
}

TEST(ContactPoints, RoadInFrontOfAnObjectStaysRoad) {
  Column column;
  column.add(0, 3, 10.0f, 0.30f, C::Unclustered);
  column.add(1, 3, 9.5f, 0.06f, C::Ground);
  EXPECT_EQ(column.release().back(), C::Ground);
}

TEST(ContactPoints, AKerbBetweenGroundsStaysGround) {
  Column column;
  column.add(0, 3, 10.0f, 0.09f, C::Ground);
  column.add(1, 3, 10.0f, 0.04f, C::Ground);
  EXPECT_THAT(column.release(), testing::ElementsAre(C::Ground, C::Ground));
}

TEST(ContactPoints, NeighbouringColumnsCountAcrossTheRearSeam) {
  Column column;
  column.add(0, 7, 10.0f, 0.30f, C::Unclustered);
  column.add(1, 0, 10.0f, 0.09f, C::Ground);
  EXPECT_EQ(column.release().back(), C::Unclustered);
}

TEST(ContactPoints, OtherClassesStayAsTheyAre) {
  Column column;
  column.add(0, 3, 10.0f, 0.30f, C::Unclustered);
  column.add(1, 3, 10.0f, 0.09f, C::BelowGround);
  EXPECT_EQ(column.release().back(), C::BelowGround);
}

}  // namespace
}  // namespace toss::test
