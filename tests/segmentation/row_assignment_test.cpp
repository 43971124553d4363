// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <toss/geometry/Error.h>
#include <toss/segmentation/RangeImageProjection.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "RealScans.h"

namespace toss::test {
namespace {

/// Returns of the given beams in ring order: azimuth grows from 0 in each ring.
Directions ringByRing(const std::vector<double>& elevations, int perRing) {
  Directions directions;
  for (const double elevation : elevations) {
    for (int i = 0; i < perRing; ++i) {
      const double turned = 2.0 * M_PI * (i + 0.5) / perRing;
      directions.azimuth.push_back(
          static_cast<float>(turned > M_PI ? turned - 2.0 * M_PI : turned));
      directions.slope.push_back(static_cast<float>(std::tan(elevation)));
      directions.valid.push_back(1);
    }
  }
  return directions;
}

std::vector<double> elevationsOf(const SensorModel& sensor, double shift) {
  std::vector<double> elevations;
  for (const float e : sensor.elevations) elevations.push_back(static_cast<double>(e) + shift);
  return elevations;
}

TEST(RowAssignment, RingOrderBeatsElevationAndMeasuresTheBeams) {
  const SensorModel& sensor = sensorByName("HDL-64E");
  // Beams that are off the table by more than one step: elevation alone would be a row off.
  const double shift = 0.009;
  const Directions directions = ringByRing(elevationsOf(sensor, shift), 500);
  std::vector<std::uint16_t> row;
  std::vector<float> elevations;
  EXPECT_EQ(RowAssignment(sensor, RowPolicy::Automatic).assign(directions, {}, row, elevations),
            RowSource::Order);
  for (std::size_t i = 0; i < row.size(); ++i) ASSERT_EQ(row[i], i / 500);
  for (std::size_t r = 0; r < elevations.size(); ++r) {
    EXPECT_NEAR(elevations[r], static_cast<double>(sensor.elevations[r]) + shift, 1e-4);
  }
}

TEST(RowAssignment, AMissingRingIsFoundByTheTable) {
  const SensorModel& sensor = sensorByName("HDL-64E");
  std::vector<double> elevations = elevationsOf(sensor, 0.0);
  elevations.erase(elevations.begin());
  std::vector<std::uint16_t> row;
  std::vector<float> measured;
  EXPECT_EQ(RowAssignment(sensor, RowPolicy::Automatic)
                .assign(ringByRing(elevations, 500), {}, row, measured),
            RowSource::Order);
  EXPECT_EQ(row.front(), 1);
  EXPECT_EQ(row.back(), 63);
  EXPECT_NEAR(measured[0], sensor.elevations[0], 1e-4) << "no returns: the table's";
}

TEST(RowAssignment, ShuffledReturnsFallBackToElevation) {
  const SensorModel& sensor = sensorByName("HDL-64E");
  Directions directions = ringByRing(elevationsOf(sensor, 0.0), 500);
  std::vector<std::size_t> order(directions.valid.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::shuffle(order.begin(), order.end(), std::mt19937(1));
  Directions shuffled;
  for (const std::size_t i : order) {
    shuffled.azimuth.push_back(directions.azimuth[i]);
    shuffled.slope.push_back(directions.slope[i]);
    shuffled.valid.push_back(1);
  }
  std::vector<std::uint16_t> row;
  std::vector<float> elevations;
  EXPECT_EQ(RowAssignment(sensor, RowPolicy::Automatic).assign(shuffled, {}, row, elevations),
            RowSource::Elevation);
  for (std::size_t i = 0; i < row.size(); ++i) ASSERT_EQ(row[i], order[i] / 500);
  EXPECT_EQ(elevations, sensor.elevations);
}

TEST(RowAssignment, ElevationGivesTheNearestBeamOfAnUnevenTable) {
  const SensorModel& sensor = sensorByName("HDL-64E");
  std::mt19937 random(2);
  std::uniform_real_distribution<double> anywhere(-0.6, 0.3);
  Directions directions;
  std::vector<double> elevation;
  for (int i = 0; i < 20000; ++i) {
    elevation.push_back(anywhere(random));
    directions.azimuth.push_back(0.0f);
    directions.slope.push_back(static_cast<float>(std::tan(elevation.back())));
    directions.valid.push_back(1);
  }
  std::vector<std::uint16_t> row;
  std::vector<float> elevations;
  RowAssignment(sensor, RowPolicy::Elevation).assign(directions, {}, row, elevations);
  for (std::size_t i = 0; i < row.size(); ++i) {
    double nearest = 10.0;
    for (const float e : sensor.elevations) {
      nearest = std::min(nearest, std::fabs(elevation[i] - static_cast<double>(e)));
    }
    const double assigned = static_cast<double>(sensor.elevations[row[i]]);
    ASSERT_NEAR(std::fabs(elevation[i] - assigned), nearest, 1e-6);
  }
}

TEST(RowAssignment, EquationOneIsEvenlySpaced) {
  const SensorModel& sensor = sensorByName("VLP-16");
  Directions directions;
  for (const double degrees : {15.0, 14.0, 0.1, -0.1, -14.9, -15.0, -40.0, 40.0}) {
    directions.azimuth.push_back(0.0f);
    directions.slope.push_back(static_cast<float>(std::tan(degrees * M_PI / 180.0)));
    directions.valid.push_back(1);
  }
  std::vector<std::uint16_t> row;
  std::vector<float> elevations;
  RowAssignment(sensor, RowPolicy::Equation).assign(directions, {}, row, elevations);
  // v = floor((1 - (elevation + 15) / 30) * 16), clamped.
  EXPECT_EQ(row, (std::vector<std::uint16_t>{0, 0, 7, 8, 15, 15, 15, 0}));
}

TEST(RowAssignment, RingsOfAnotherSensorAreTheUsersError) {
  const Directions directions = ringByRing({0.0, -0.1}, 50);
  std::vector<std::uint16_t> ring(directions.valid.size(), 20), row;
  std::vector<float> elevations;
  RowAssignment rows(sensorByName("VLP-16"), RowPolicy::Automatic);
  EXPECT_THROW(rows.assign(directions, ring, row, elevations), UserError);
  std::fill(ring.begin(), ring.end(), std::uint16_t{15});
  EXPECT_EQ(rows.assign(directions, ring, row, elevations), RowSource::Ring);
  EXPECT_EQ(row, ring);
}

TEST(RowAssignment, RealScansHoldExactly64Rings) {
  TOSS_NEED_REAL_DATA(KittiSequence::folder());
  const KittiSequence sequence;
  RangeImageProjection projection(ProjectionOptions{}, sensorByName("HDL-64E"));
  RangeImage image;
  std::vector<PointClass> pointClass;
  for (std::size_t scan = 0; scan < sequence.size(); scan += 9) {
    const PointCloud points = sequence.points(scan);
    projection.project(points, image, pointClass);
    ASSERT_EQ(projection.rowSource(), RowSource::Order);
    std::vector<int> count(64, 0);
    std::uint16_t last = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (image.row[i] == RangeImage::kNoRow) continue;
      ASSERT_TRUE(image.row[i] == last || image.row[i] == last + 1) << "rings come one by one";
      last = image.row[i];
      ++count[last];
    }
    for (const int returns : count) EXPECT_GT(returns, 500);
    EXPECT_TRUE(std::is_sorted(image.elevations.rbegin(), image.elevations.rend()));
  }
}

TEST(RowAssignment, RealReturnsMostlyHaveAPixelOfTheirOwn) {
  TOSS_NEED_REAL_DATA(KittiSequence::folder());
  RangeImageProjection projection(ProjectionOptions{}, sensorByName("HDL-64E"));
  RangeImage image;
  std::vector<PointClass> pointClass;
  projection.project(KittiSequence().points(50), image, pointClass);
  const auto filled = image.representative.size() -
                      static_cast<std::size_t>(
                          std::count(image.representative.begin(), image.representative.end(), -1));
  const auto used = std::count(pointClass.begin(), pointClass.end(), PointClass::Unclustered);
  EXPECT_GT(static_cast<double>(filled) / static_cast<double>(used), 0.90);
}

}  // namespace
}  // namespace toss::test
