// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "BoxClaims.h"

namespace toss::test {
namespace {

constexpr double kMargin = 0.15, kResidue = 0.02;
const Eigen::Vector3d kSensor(1000.0, -500.0, 20.0);

/// A made-up scan of returns of all classes, half of its instances standing, and boxes.
struct ClaimScene {
  LevelPoints points;
  Segmentation segmentation;
  std::vector<BoxClaims::Claimant> claimants;
  std::vector<bool> standing;
};

ClaimScene randomScene() {
  ClaimScene scene;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> anywhere(-60.0, 60.0), edge(0.5, 8.0), yaw(-3.0, 3.0);
  std::uniform_real_distribution<float> height(-2.0f, 2.0f), above(-0.1f, 0.1f);
  std::uniform_int_distribution<int> kind(0, 5), instance(1, 9);
  for (int b = 0; b < 300; ++b) {
    Box box;
    box.center = kSensor + Eigen::Vector3d(anywhere(random), anywhere(random), 0.0);
    box.length = edge(random), box.width = edge(random), box.height = 0.5 * edge(random);
    box.yaw = yaw(random);
    scene.claimants.push_back({box, b % 3 == 0});
  }
  for (int i = 0; i < 20000; ++i) {
    scene.points.x.push_back(static_cast<float>(anywhere(random)));
    scene.points.y.push_back(static_cast<float>(anywhere(random)));
    scene.points.z.push_back(height(random));
    const auto pointClass = static_cast<PointClass>(kind(random));
    scene.segmentation.pointClass.push_back(pointClass);
    const bool inInstance = pointClass == PointClass::Instance;
    scene.segmentation.instance.push_back(inInstance ? instance(random) : 0);
    scene.segmentation.heightAboveGround.push_back(above(random));
  }
  for (int k = 0; k < 10; ++k) scene.standing.push_back(k % 2 == 0);
  return scene;
}

bool holds(const BoxClaims::Claimant& claimant, const Eigen::Vector3d& point) {
  const Box& box = claimant.box;
  const double margin = claimant.cutsInstances ? 0.0 : kMargin;
  const Eigen::Vector3d inBox =
      Eigen::AngleAxisd(-box.yaw, Eigen::Vector3d::UnitZ()) * (point - box.center);
  return std::abs(inBox.x()) <= 0.5 * box.length + margin &&
         std::abs(inBox.y()) <= 0.5 * box.width + margin &&
         inBox.z() <= 0.5 * box.height + margin && inBox.z() >= -0.5 * box.height - 1.0;
}

/// Claimant of a return by comparison with every box; -1 = none.
std::int32_t claimantByAll(const ClaimScene& scene, std::size_t i) {
  const PointClass pointClass = scene.segmentation.pointClass[i];
  const bool ofInstance = pointClass == PointClass::Instance;
  const auto instance = static_cast<std::size_t>(scene.segmentation.instance[i]);
  const double height = static_cast<double>(scene.segmentation.heightAboveGround[i]);
  if (!(pointClass == PointClass::Unclustered || (ofInstance && scene.standing[instance]) ||
        (pointClass == PointClass::Ground && height > kResidue)))
    return -1;
  const Eigen::Vector3d point =
      kSensor +
      Eigen::Vector3f(scene.points.x[i], scene.points.y[i], scene.points.z[i]).cast<double>();
  std::int32_t best = -1;
  double least = 0.0;
  for (std::size_t c = 0; c < scene.claimants.size(); ++c) {
    const BoxClaims::Claimant& claimant = scene.claimants[c];
    if ((ofInstance && !claimant.cutsInstances) || !holds(claimant, point)) continue;
    const double volume = claimant.box.volume();
    if (best < 0 || volume < least) best = static_cast<std::int32_t>(c), least = volume;
  }
  return best;
}

TEST(BoxClaims, FindsWhatComparisonWithAllBoxesFinds) {
  const ClaimScene scene = randomScene();
  BoxClaims claims(kMargin, kResidue);
  NearbyReturns nearby;
  std::vector<BoxClaims::Claim> found;
  claims.take(scene.claimants, kSensor);
  claims.markNearby(nearby);
  nearby.find(scene.points, scene.segmentation.pointClass);
  claims.find(scene.points, scene.segmentation, nearby, scene.standing, found);
  std::vector<std::int32_t> claimants(scene.points.x.size(), -1), expected = claimants;
  for (const BoxClaims::Claim& claim : found)
    claimants[static_cast<std::size_t>(claim.point)] = claim.claimant;
  for (std::size_t i = 0; i < expected.size(); ++i) expected[i] = claimantByAll(scene, i);
  EXPECT_EQ(claimants, expected);
  EXPECT_GT(found.size(), 1000u);
}

TEST(BoxClaims, NamesTheSmallestOtherBoxAroundAPoint) {
  const auto boxOf = [](double edge) {
    Box box;
    box.center = {5.0, 0.0, 0.0};
    box.length = box.width = box.height = edge;
    return BoxClaims::Claimant{box, false};
  };
  BoxClaims claims(0.0, 0.0);
  claims.take({boxOf(1.0), boxOf(4.0), boxOf(2.0)}, Eigen::Vector3d::Zero());
  EXPECT_EQ(claims.boxAround({5.0f, 0.2f, 0.0f}, -1), 0);
  EXPECT_EQ(claims.boxAround({5.0f, 0.2f, 0.0f}, 0), 2);
  EXPECT_EQ(claims.boxAround({5.0f, 1.8f, 0.0f}, 2), 1);
  EXPECT_EQ(claims.boxAround({5.0f, 2.2f, 0.0f}, -1), -1);
}

TEST(NearbyReturns, FindsReturnsBeyondItsGridAndNoneThatAreNotThere) {
  NearbyReturns nearby;
  nearby.mark({Eigen::Vector2f(150.0f, -0.5f), Eigen::Vector2f(151.0f, 0.5f)},
              NearbyReturns::Of::NoInstance);
  const float unknown = std::nanf("");
  const LevelPoints points{{150.5f, 0.0f, unknown, 150.5f}, {0.0f, 0.0f, unknown, 0.0f}, {}};
  nearby.find(points,
              {PointClass::Ground, PointClass::Ground, PointClass::Invalid, PointClass::Instance});
  EXPECT_EQ(std::vector<std::int32_t>(nearby.begin(), nearby.end()), std::vector<std::int32_t>{0});
}

}  // namespace
}  // namespace toss::test
