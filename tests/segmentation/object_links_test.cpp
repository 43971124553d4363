// SPDX-License-Identifier: BSD-3-Clause
// The clusters against brute force: connected components over all pairs of returns.
#include <gtest/gtest.h>
#include <toss/segmentation/LinkRules.h>
#include <toss/segmentation/ObjectSegmentation.h>

#include <random>

#include "ObjectTestScan.h"

namespace toss {
namespace {

using test::ObjectTestScan;

/// Straight from the definition in LinkRules.h.
bool linked(const ObjectTestScan& scan, const LinkRules& rules, std::size_t a, std::size_t b) {
  const auto horizontalRange = [&](std::size_t i) {
    return std::sqrt(scan.points.x[i] * scan.points.x[i] + scan.points.y[i] * scan.points.y[i]);
  };
  const LinkRules::Reach reachA = rules.reach(horizontalRange(a));
  const LinkRules::Reach reachB = rules.reach(horizontalRange(b));
  const int rowGap = std::abs(scan.image.row[a] - scan.image.row[b]);
  const int straight = std::abs(scan.image.column[a] - scan.image.column[b]);
  const int columnGap = std::min(straight, scan.image.columns - straight);
  const float limit = rowGap == 0 ? std::min(reachA.horizontal, reachB.horizontal)
                                  : std::min(reachA.vertical, reachB.vertical);
  const float dx = scan.points.x[a] - scan.points.x[b], dy = scan.points.y[a] - scan.points.y[b];
  const float distance = std::hypot(dx, dy), dz = std::abs(scan.points.z[a] - scan.points.z[b]);
  const bool near = rowGap <= rules.rowWindow &&
                    columnGap <= std::min(reachA.window, reachB.window) && distance < limit &&
                    (rowGap <= 1 || dz <= rules.maxHeightGap);
  const bool grazed = rowGap == 1 && columnGap <= 1 && distance < rules.surfaceDistance &&
                      std::max(scan.points.z[a], scan.points.z[b]) <= -rules.surfaceDepth;
  return near || grazed;
}

/// Returns that are nodes, by pixel; and for each return the node it shares: the first one of its
/// pixel at about its range.
std::vector<std::size_t> nodesOf(const ObjectTestScan& scan, double pixelMerge,
                                 std::vector<std::size_t>& host) {
  std::vector<std::size_t> nodes;
  host.resize(scan.size());
  for (const std::int32_t head : scan.image.representative) {
    const std::size_t begin = nodes.size();
    for (std::int32_t p = head; p >= 0; p = scan.image.next[static_cast<std::size_t>(p)]) {
      const std::size_t i = static_cast<std::size_t>(p);
      std::size_t n = begin;
      while (n < nodes.size() && std::abs(scan.image.range[i] - scan.image.range[nodes[n]]) >=
                                     static_cast<float>(pixelMerge)) {
        ++n;
      }
      if (n == nodes.size()) nodes.push_back(i);
      host[i] = nodes[n];
    }
  }
  return nodes;
}

std::vector<std::int32_t> bruteForceInstances(const ObjectTestScan& scan,
                                              const ObjectOptions& options) {
  const LinkRules rules(options, scan.image);
  std::vector<std::size_t> host;
  const std::vector<std::size_t> nodes = nodesOf(scan, options.pixelMerge, host);
  std::vector<std::int32_t> instance(scan.size(), 0);
  std::int32_t count = 0;
  for (const std::size_t first : nodes) {
    if (instance[first] != 0) continue;
    instance[first] = ++count;
    for (std::vector<std::size_t> open{first}; !open.empty();) {
      const std::size_t a = open.back();
      open.pop_back();
      for (const std::size_t b : nodes) {
        if (instance[b] != 0 || !linked(scan, rules, a, b)) continue;
        instance[b] = count;
        open.push_back(b);
      }
    }
  }
  for (std::size_t i = 0; i < scan.size(); ++i) instance[i] = instance[host[i]];
  return instance;
}

/// Surfaces that come and go at random, some with a second surface behind, full circle; `tilt`
/// [rad] turns the level frame about the sensor's x axis.
ObjectTestScan randomScan(unsigned seed, double tilt) {
  ObjectTestScan scan(14, 180, 0.3, -0.3);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const double scale = 1.0 + 30.0 * uniform(random);
  for (int row = 0; row < scan.image.rows; ++row) {
    double range = scale;
    for (int column = 0; column < scan.image.columns; ++column) {
      if (uniform(random) < 0.1) range = scale * (0.3 + uniform(random));
      range *= 1.0 + 0.02 * (uniform(random) - 0.5);
      if (uniform(random) < 0.2) continue;
      scan.add(row, column, range);
      for (int more = 0; more < 3 && uniform(random) < 0.2; ++more) {
        scan.add(row, column, range + uniform(random));
      }
    }
  }
  for (std::size_t i = 0; i < scan.size(); ++i) {
    float &y = scan.points.y[i], &z = scan.points.z[i];
    const float c = static_cast<float>(std::cos(tilt)), s = static_cast<float>(std::sin(tilt));
    std::tie(y, z) = std::make_pair(c * y - s * z, s * y + c * z);
  }
  return scan;
}

/// Every component an instance, as clustering leaves it.
ObjectOptions bareClustering() {
  ObjectOptions options;
  options.minPointsNear = options.minPointsFar = 1;
  options.attachDistance = 0.0;
  options.splitExtent = 0.0;
  return options;
}

void expectBruteForce(const ObjectOptions& options, double tilt) {
  ObjectSegmentation objects(options);
  for (unsigned seed = 0; seed < 6; ++seed) {
    ObjectTestScan scan = randomScan(seed, tilt);
    objects.segment(scan.points, scan.image, scan.segmentation);
    ASSERT_EQ(scan.segmentation.instance, bruteForceInstances(scan, options)) << "seed " << seed;
    ASSERT_GT(scan.segmentation.instanceCount, 5);
  }
}

TEST(ObjectLinks, AdaptiveClustersEqualBruteForce) {
  expectBruteForce(bareClustering(), 0.0);
}

TEST(ObjectLinks, ClustersOfATiltedSensorEqualBruteForce) {
  expectBruteForce(bareClustering(), 0.35);
}

TEST(ObjectLinks, GrazedSurfacesEqualBruteForce) {
  ObjectOptions options = bareClustering();
  options.surfaceDistance = 2.0;
  options.surfaceDepth = 0.2;
  expectBruteForce(options, 0.0);
}

TEST(ObjectLinks, ConstantClustersEqualBruteForce) {
  ObjectOptions options = bareClustering();
  options.metric = LinkMetric::Constant;
  expectBruteForce(options, 0.0);
}

TEST(ObjectLinks, WideWindowsAndTightHeightsEqualBruteForce) {
  ObjectOptions options = bareClustering();
  options.rowWindow = 8;
  options.maxHeightGap = 0.4;
  options.horizontalDistance = options.verticalDistance = 1.2;
  options.pixelMerge = 0.0;
  expectBruteForce(options, 0.1);
}

/// Distances of spec section 3.3: 1.2 and 1.5 times half a degree, 0.4 to 1.5 times the base.
ObjectOptions specifiedLinks() {
  ObjectOptions options;
  options.horizontalAngle = 1.2 * 0.00873, options.verticalAngle = 1.5 * 0.00873;
  options.nearFactor = 0.4, options.farFactor = 1.5;
  options.horizontalDistance = 0.4, options.verticalDistance = 0.5;
  return options;
}

TEST(LinkRules, DistancesFollowTheAngleBetweenTheirBounds) {
  ObjectTestScan scan(3, 2048, 0.01, -0.01);
  const LinkRules rules(specifiedLinks(), scan.image);
  EXPECT_FLOAT_EQ(rules.rowStep, 0.01f);
  EXPECT_FLOAT_EQ(rules.reach(1.0f).horizontal, 0.16f);
  EXPECT_FLOAT_EQ(rules.reach(1.0f).vertical, 0.2f);
  EXPECT_NEAR(rules.reach(20.0f).horizontal, 20.0 * 1.2 * 0.00873, 1e-5);
  EXPECT_NEAR(rules.reach(20.0f).vertical, 20.0 * 1.5 * 0.00873, 1e-5);
  EXPECT_FLOAT_EQ(rules.reach(80.0f).horizontal, 0.6f);
  EXPECT_FLOAT_EQ(rules.reach(80.0f).vertical, 0.75f);
}

TEST(LinkRules, AnglesSpanTheBeamsOfSparseSensors) {
  ObjectTestScan scan(3, 512, 0.04, -0.04);
  const LinkRules rules(specifiedLinks(), scan.image);
  EXPECT_NEAR(rules.reach(15.0f).horizontal, 15.0 * 2.5 * 2.0 * M_PI / 512.0, 1e-5);
  EXPECT_NEAR(rules.reach(15.0f).vertical, 15.0 * 0.04, 1e-5);
}

TEST(LinkRules, ConstantDistancesDoNotDependOnRange) {
  ObjectOptions options;
  options.metric = LinkMetric::Constant;
  options.horizontalDistance = 0.4, options.verticalDistance = 0.5;
  const LinkRules rules(options, ObjectTestScan::hdl64().image);
  for (const float range : {1.0f, 20.0f, 80.0f}) {
    EXPECT_FLOAT_EQ(rules.reach(range).horizontal, 0.4f);
    EXPECT_FLOAT_EQ(rules.reach(range).vertical, 0.5f);
  }
}

TEST(LinkRules, WindowSpansTheLinkDistance) {
  const ObjectOptions options;
  const LinkRules rules(options, ObjectTestScan::hdl64().image);
  for (float range : {0.5f, 2.0f, 5.0f, 20.0f, 80.0f}) {
    const LinkRules::Reach reach = rules.reach(range);
    const double widest = std::max(reach.horizontal, reach.vertical);
    EXPECT_GE(reach.window, std::asin(widest / range) / (2.0 * M_PI / 2048.0)) << range;
  }
}

TEST(LinkRules, FewestReturnsShrinkWithRange) {
  ObjectOptions options;
  options.minPointsNear = 10, options.minPointsFar = 3, options.minSize = 0.3;
  const LinkRules rules(options, ObjectTestScan::hdl64().image);
  EXPECT_EQ(rules.minPoints(5.0f), 10);
  EXPECT_EQ(rules.minPoints(60.0f), 3);
  // At 25 m a square of 0.3 m takes 0.3 / (25 * 0.00307) = 3.9 columns by 1.6 rows.
  EXPECT_EQ(rules.minPoints(25.0f), 6);
  options.splitMinSize = 0.6;
  const LinkRules larger(options, ObjectTestScan::hdl64().image);
  EXPECT_EQ(larger.minPointsOfPart(25.0f), 25);
  EXPECT_EQ(larger.minPointsOfPart(200.0f), 3);
}

}  // namespace
}  // namespace toss
