// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <toss/geometry/Error.h>
#include <toss/simulation/SceneCatalogue.h>
#include <toss/simulation/Simulator.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>

namespace toss {
namespace {

SimulationOptions crossing(int frames = 3) {
  SimulationOptions options;
  options.scene = "crossing";
  options.frames = frames;
  return options;
}

/// All bytes that a log would hold.
std::string bytesOf(const SimulationOptions& options) {
  std::string bytes;
  const auto add = [&](const auto& values) {
    bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(values[0]));
  };
  Simulator simulator(options);
  for (SimulatedScan simulated; simulator.next(simulated);) {
    const PointCloud& points = simulated.scan.points;
    add(points.x), add(points.y), add(points.z), add(points.intensity), add(points.ring);
    add(points.time), add(simulated.labels);
    const Eigen::Matrix4d pose = simulated.scan.mapFromSensor.matrix();
    bytes.append(reinterpret_cast<const char*>(pose.data()), sizeof(double) * 16);
  }
  return bytes;
}

TEST(Simulator, TheSameSeedGivesTheSameBytesAndAnotherSeedOthers) {
  SimulationOptions options = crossing();
  options.poseNoise = 1.0;
  const std::string first = bytesOf(options);
  EXPECT_EQ(first, bytesOf(options));
  options.seed = 2;
  EXPECT_NE(first, bytesOf(options));
}

TEST(Simulator, TheNumberOfThreadsDoesNotShow) {
  SimulationOptions options;
  options.scene = "street";
  options.frames = 2;
  options.threads = 1;
  const std::string one = bytesOf(options);
  options.threads = 2;
  EXPECT_EQ(one, bytesOf(options));
}

TEST(Simulator, MoversCarryTheirClassAndTheirPointsLieInTheirBoxes) {
  Simulator simulator(crossing(30));
  EXPECT_EQ(simulator.frames(), 30);
  std::map<std::uint32_t, int> seen;
  for (SimulatedScan simulated; simulator.next(simulated);) {
    std::map<std::uint32_t, std::uint32_t> counts;
    for (std::size_t i = 0; i < simulated.labels.size(); ++i) {
      const std::uint32_t track = simulated.labels[i] >> 16;
      if (track != 0) ++counts[simulated.labels[i]];
    }
    ASSERT_EQ(counts.size(), simulated.boxes.size());
    for (const GroundTruthBox& box : simulated.boxes) {
      EXPECT_EQ(counts[std::uint32_t{box.track} << 16 | box.label], box.points);
      EXPECT_EQ(box.moving, box.label >= 252);
      ++seen[box.label];
    }
    const PointCloud& points = simulated.scan.points;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if ((simulated.labels[i] & 0xFFFFu) != 252) continue;
      const Eigen::Vector3d inMap =
          simulated.scan.mapFromSensor *
          Eigen::Vector3f(points.x[i], points.y[i], points.z[i]).cast<double>();
      for (const GroundTruthBox& box : simulated.boxes) {
        // 6 m/s for half a sweep, and beams that straddle the edge of the car.
        if (box.label == 252) {
          EXPECT_TRUE(contains(box.box, inMap, 0.9));
        }
      }
    }
  }
  EXPECT_GT(seen[252], 20);
  EXPECT_GT(seen[254], 20);
  EXPECT_EQ(seen[10], 30);
}

TEST(Simulator, WhatMovesLaterInTheLogIsMovingFromTheFirstScan) {
  SimulationOptions options;
  options.scene = "junction";
  options.frames = 1;
  SimulatedScan simulated;
  Simulator still(options);
  ASSERT_TRUE(still.next(simulated));
  for (const GroundTruthBox& box : simulated.boxes) EXPECT_FALSE(box.moving);
  options.frames = 0;
  Simulator whole(options);
  ASSERT_TRUE(whole.next(simulated));
  int standing = 0;
  for (const GroundTruthBox& box : simulated.boxes) {
    if (box.moving && box.velocity.norm() < 1e-6) ++standing;
  }
  EXPECT_GT(standing, 0);
}

/// Where the rule for KITTI's order sees a new ring: a drop of the azimuth by more than half a
/// turn.
std::vector<std::size_t> ringStartsByOrder(const PointCloud& points) {
  std::vector<std::size_t> starts;
  double previous = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    double azimuth = std::atan2(points.y[i], points.x[i]);
    if (azimuth < 0.0) azimuth += 2.0 * M_PI;
    if (previous - azimuth > M_PI) starts.push_back(i);
    previous = azimuth;
  }
  return starts;
}

std::vector<std::size_t> ringStarts(const PointCloud& points) {
  std::vector<std::size_t> starts;
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (points.ring[i] != points.ring[i - 1]) starts.push_back(i);
  }
  return starts;
}

class EveryScene : public testing::TestWithParam<std::string> {};

TEST_P(EveryScene, ShowsMoversAndKeepsTheOrderOfRings) {
  SimulationOptions options;
  options.scene = GetParam();
  Simulator simulator(options);
  SimulatedScan simulated;
  std::ptrdiff_t movers = 0;
  for (int scan = 0; scan < 2; ++scan) {
    ASSERT_TRUE(simulator.next(simulated));
    const PointCloud& points = simulated.scan.points;
    ASSERT_GT(points.size(), 5000u);
    ASSERT_EQ(points.size(), simulated.labels.size());
    ASSERT_EQ(points.size(), points.ring.size());
    ASSERT_EQ(points.size(), points.time.size());
    EXPECT_TRUE(std::is_sorted(points.ring.begin(), points.ring.end()));
    const std::vector<std::size_t> byOrder = ringStartsByOrder(points), starts = ringStarts(points);
    // Rings of an upper beam that only meets a tree or two can not be told by their azimuths.
    EXPECT_TRUE(std::includes(starts.begin(), starts.end(), byOrder.begin(), byOrder.end()));
    if (simulator.sensorName() == "HDL-64E") {
      EXPECT_EQ(byOrder.size(), 63u);
    }
    movers = std::count_if(simulated.boxes.begin(), simulated.boxes.end(),
                           [](const GroundTruthBox& box) { return box.moving; });
  }
  EXPECT_GT(movers, 0);
}

std::vector<std::string> sceneNames() {
  std::vector<std::string> names;
  for (const SceneInfo& info : knownScenes()) names.push_back(info.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Simulator, EveryScene, testing::ValuesIn(sceneNames()),
                         [](const auto& scene) {
                           std::string name = scene.param;
                           for (char& c : name) c = c == '-' ? '_' : c;
                           return name;
                         });

TEST(Simulator, PoseNoiseIsSmallAndGrowsWithTheFactor) {
  const auto largest = [](double factor) {
    SimulationOptions options = crossing(30);
    options.poseNoise = factor;
    Simulator simulator(options);
    double error = 0.0;
    for (SimulatedScan s; simulator.next(s);) {
      error = std::max(
          error, (s.scan.mapFromSensor.translation() - s.trueMapFromSensor.translation()).norm());
    }
    return error;
  };
  EXPECT_EQ(largest(0.0), 0.0);
  EXPECT_GT(largest(1.0), 0.005);
  EXPECT_LT(largest(1.0), 0.12);
  EXPECT_GT(largest(5.0), 2.0 * largest(1.0));
}

TEST(Simulator, WhatIsOutOfRangeIsSaidInOneLine) {
  SimulationOptions options = crossing();
  options.scene = "crosing";
  try {
    Simulator simulator(options);
    FAIL() << "no error";
  } catch (const UserError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("crossing"));
  }
  options = crossing();
  options.sensor = "VLP16";
  EXPECT_THROW(Simulator{options}, UserError);
  options = crossing();
  options.frames = -1;
  EXPECT_THROW(Simulator{options}, UserError);
  options = crossing();
  options.poseNoise = std::nan("");
  EXPECT_THROW(Simulator{options}, UserError);
}

}  // namespace
}  // namespace toss
