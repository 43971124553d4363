// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <toss/geometry/Error.h>
#include <toss/segmentation/RangeImageProjection.h>

#include <cmath>
#include <limits>
#include <random>
#include <set>

namespace toss::test {
namespace {

void append(PointCloud& points, double azimuth, double elevation, double range) {
  points.x.push_back(static_cast<float>(range * std::cos(elevation) * std::cos(azimuth)));
  points.y.push_back(static_cast<float>(range * std::cos(elevation) * std::sin(azimuth)));
  points.z.push_back(static_cast<float>(range * std::sin(elevation)));
  points.intensity.push_back(0.5f);
}

struct Projected {
  RangeImage image;
  std::vector<PointClass> pointClass;
  RowSource source;

  Projected(const PointCloud& points, const char* sensor, const ProjectionOptions& options = {}) {
    RangeImageProjection projection(options, sensorByName(sensor));
    projection.project(points, image, pointClass);
    source = projection.rowSource();
  }
};

/// Points of a pixel, nearest first and then in the order of the chain.
std::vector<std::int32_t> chainOf(const RangeImage& image, int row, int column) {
  std::vector<std::int32_t> chain;
  for (std::int32_t p = image.at(row, column); p != RangeImage::kNone;
       p = image.next[static_cast<std::size_t>(p)]) {
    chain.push_back(p);
  }
  return chain;
}

class ProjectionOfSensor : public testing::TestWithParam<const char*> {};

TEST_P(ProjectionOfSensor, PixelToDirectionToPixelIsTheSamePixel) {
  const SensorModel& sensor = sensorByName(GetParam());
  PointCloud points;
  for (int row = 0; row < sensor.rows(); ++row) {
    for (int column = 0; column < sensor.columns; column += 7) {
      append(points, static_cast<double>(azimuthOfColumn(column, sensor.columns)),
             static_cast<double>(sensor.elevations[static_cast<std::size_t>(row)]),
             20.0 + row * 0.1);
    }
  }
  ProjectionOptions options;
  options.rowSource = RowPolicy::Elevation;
  const Projected projected(points, GetParam(), options);
  std::size_t i = 0;
  for (int row = 0; row < sensor.rows(); ++row) {
    for (int column = 0; column < sensor.columns; column += 7, ++i) {
      ASSERT_EQ(projected.image.row[i], row);
      ASSERT_EQ(projected.image.column[i], column);
      ASSERT_EQ(projected.image.at(row, column), static_cast<std::int32_t>(i));
      ASSERT_NEAR(projected.image.range[i], 20.0 + row * 0.1, 1e-4);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Sensors, ProjectionOfSensor,
                         testing::Values("HDL-64E", "HDL-32E", "VLP-16", "OS0-128", "OS1-64"));

TEST(Projection, ColumnsFollowTheExactAzimuth) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> turn(-M_PI, M_PI);
  PointCloud points;
  std::vector<double> expected;
  for (int i = 0; i < 50000; ++i) {
    const double azimuth = turn(random);
    append(points, azimuth, 0.0, 10.0);
    expected.push_back(0.5 * (1.0 - azimuth / M_PI) * 1800.0);
  }
  const Projected projected(points, "VLP-16");
  for (std::size_t i = 0; i < expected.size(); ++i) {
    // 1e-4 rad is 0.03 columns: the pixel may differ only that close to its border.
    const double off = expected[i] - (projected.image.column[i] + 0.5);
    ASSERT_LT(std::fabs(off), 0.53) << expected[i];
  }
}

TEST(Projection, TheRearSeamIsColumnZeroFromBothSides) {
  PointCloud points;
  points.resize(3);
  points.x = {-10.0f, -10.0f, -10.0f};
  points.y = {0.0f, -0.0f, 1e-3f};
  const Projected projected(points, "HDL-64E");
  EXPECT_THAT(projected.image.column, testing::ElementsAre(0, 0, 0));
  EXPECT_EQ(columnOfAzimuth(static_cast<float>(-M_PI), 2011), 0);
  EXPECT_EQ(columnOfAzimuth(static_cast<float>(M_PI), 2011), 0);
  EXPECT_EQ(columnOfAzimuth(static_cast<float>(-M_PI + 1e-3), 2011), 2010);
}

TEST(Projection, EveryReturnHangsInItsPixelAndTheNearestIsInFront) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> azimuth(-0.05, 0.05), range(2.0, 60.0);
  PointCloud points;
  for (int i = 0; i < 3000; ++i) append(points, azimuth(random), -0.02, range(random));
  const Projected projected(points, "VLP-16");
  std::multiset<std::int32_t> seen;
  for (int row = 0; row < projected.image.rows; ++row) {
    for (int column = 0; column < projected.image.columns; ++column) {
      const auto chain = chainOf(projected.image, row, column);
      for (const std::int32_t p : chain) {
        const auto point = static_cast<std::size_t>(p);
        EXPECT_EQ(projected.image.row[point], row);
        EXPECT_EQ(projected.image.column[point], column);
        EXPECT_LE(projected.image.range[static_cast<std::size_t>(chain.front())],
                  projected.image.range[point]);
        seen.insert(p);
      }
    }
  }
  EXPECT_EQ(seen.size(), points.size());
  EXPECT_EQ(std::set<std::int32_t>(seen.begin(), seen.end()).size(), points.size());
}

TEST(Projection, ManyReturnsInOnePixelTakeLinearTime) {
  PointCloud points;
  for (int i = 0; i < 200000; ++i) append(points, 0.0, 0.0, 10.0);
  EXPECT_EQ(chainOf(Projected(points, "VLP-16").image, 7, 900).size(), points.size());
}

TEST(Projection, BadReturnsAreSortedOut) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  PointCloud points;
  points.resize(9);
  points.x = {nan, 10, 0, 1e38f, 0.1f, 100, 2, 10, 10};
  points.y = {0, infinity, 0, 1e38f, 0, 0, 1, 0, 0};
  points.z = {0, 0, 0, 0, 0, 0, 5, 9, -9};
  ProjectionOptions options;
  options.egoRadius = 2.5, options.minZ = -5.0, options.maxRange = 80.0;
  const Projected projected(points, "HDL-64E", options);
  using C = PointClass;
  EXPECT_THAT(projected.pointClass,
              testing::ElementsAre(C::Invalid, C::Invalid, C::Invalid, C::OutOfRange, C::Invalid,
                                   C::OutOfRange, C::Invalid, C::Unclustered, C::OutOfRange));
  EXPECT_EQ(projected.image.row[7], 0) << "above the top beam";
  for (std::size_t i = 0; i < 9; ++i) {
    EXPECT_EQ(projected.image.row[i] == RangeImage::kNoRow, i != 7);
    if (projected.pointClass[i] == C::Invalid) {
      EXPECT_EQ(projected.image.range[i], 0.0f);
    }
  }
}

TEST(Projection, LimitsOfZeroAreTheSensors) {
  PointCloud points;
  for (const double range : {0.2, 0.4, 74.0, 76.0}) append(points, 1.0, 0.0, range);
  ProjectionOptions options;
  options.maxRange = 0.0;
  using C = PointClass;
  EXPECT_THAT(Projected(points, "OS0-128", options).pointClass,
              testing::ElementsAre(C::OutOfRange, C::Unclustered, C::Unclustered, C::OutOfRange));
}

TEST(Projection, OptionsOutOfRangeAreRefused) {
  ProjectionOptions options;
  options.columns = 70000;
  EXPECT_THROW(RangeImageProjection(options, sensorByName("VLP-16")), UserError);
  EXPECT_THROW(RangeImageProjection(ProjectionOptions{}, SensorModel{}), UserError);
}

}  // namespace
}  // namespace toss::test
