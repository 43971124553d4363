// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "GroundContact.h"

namespace toss::test {
namespace {

/// A made-up scan of bodies and ground.
struct FeetScene {
  LevelPoints points;
  Segmentation segmentation;
  std::vector<GroundContact::Body> bodies;

  void add(float x, float y, float z, PointClass pointClass, float height) {
    points.x.push_back(x), points.y.push_back(y), points.z.push_back(z);
    segmentation.pointClass.push_back(pointClass);
    segmentation.heightAboveGround.push_back(height);
    segmentation.instance.push_back(0);
  }
  /// Ends an instance that holds all points from `first` on.
  void endInstance(std::int32_t claimant, std::size_t first) {
    if (segmentation.memberBegin.empty()) segmentation.memberBegin.push_back(0);
    ++segmentation.instanceCount;
    for (std::size_t i = first; i < points.x.size(); ++i) {
      segmentation.members.push_back(static_cast<std::int32_t>(i));
      segmentation.instance[i] = segmentation.instanceCount;
    }
    segmentation.memberBegin.push_back(static_cast<std::int32_t>(segmentation.members.size()));
    bodies.push_back({segmentation.instanceCount, claimant});
  }
  std::vector<BoxClaims::Claim> find(double distance) const {
    std::vector<BoxClaims::Claim> claims;
    GroundContact contact(distance);
    NearbyReturns nearby;
    contact.take(points, segmentation, bodies);
    contact.markNearby(nearby);
    nearby.find(points, segmentation.pointClass);
    contact.find(points, segmentation, nearby, claims);
    return claims;
  }
};

/// Bodies of returns that stand far enough apart for each to count, on random ground.
FeetScene randomScene() {
  FeetScene scene;
  std::mt19937 random(7);
  std::uniform_real_distribution<float> anywhere(-60.0f, 60.0f), height(0.02f, 0.9f),
      around(-0.4f, 0.4f);
  std::vector<Eigen::Vector2f> feet;
  for (std::int32_t body = 0; body < 60; ++body) {
    const std::size_t first = scene.points.x.size();
    const float x = anywhere(random), y = anywhere(random);
    for (int k = 0; k < 4; ++k) {
      feet.emplace_back(x + 0.2f * static_cast<float>(k), y);
      const float h = height(random);
      scene.add(feet.back().x(), y, h - 1.7f, PointClass::Instance, h);
    }
    scene.endInstance(body, first);
  }
  for (const Eigen::Vector2f& foot : feet)
    for (int k = 0; k < 20; ++k)
      scene.add(foot.x() + around(random), foot.y() + around(random), -1.7f, PointClass::Ground, 0);
  return scene;
}

/// Claimant of a point by comparison with every return of every body; -1 = none.
std::int32_t claimantByAll(const FeetScene& scene, std::size_t i, float distance) {
  const LevelPoints& p = scene.points;
  float best = std::min(distance, std::max(0.03f, 0.012f * std::hypot(p.x[i], p.y[i])));
  std::int32_t claimant = -1;
  for (const GroundContact::Body& body : scene.bodies) {
    const auto k = static_cast<std::size_t>(body.instance);
    for (auto m = scene.segmentation.memberBegin[k - 1]; m < scene.segmentation.memberBegin[k];
         ++m) {
      const auto j = static_cast<std::size_t>(m);
      const float gap = std::hypot(p.x[i] - p.x[j], p.y[i] - p.y[j]);
      if (scene.segmentation.heightAboveGround[j] < 0.5f && gap < best)
        best = gap, claimant = body.claimant;
    }
  }
  return claimant;
}

TEST(GroundContact, FindsWhatComparisonWithAllFeetFinds) {
  const FeetScene scene = randomScene();
  std::vector<std::int32_t> found(scene.points.x.size(), -1), expected = found;
  for (const BoxClaims::Claim& claim : scene.find(0.15))
    found[static_cast<std::size_t>(claim.point)] = claim.claimant;
  for (std::size_t i = 0; i < expected.size(); ++i)
    if (scene.segmentation.pointClass[i] == PointClass::Ground)
      expected[i] = claimantByAll(scene, i, 0.15f);
  EXPECT_EQ(found, expected);
  EXPECT_GT(std::count_if(found.begin(), found.end(), [](auto c) { return c >= 0; }), 50);
}

TEST(GroundContact, LeavesGroundBesideABodyThatHangs) {
  FeetScene scene;
  scene.add(10.0f, 0.0f, 0.0f, PointClass::Instance, 1.7f);
  scene.endInstance(3, 0);
  scene.add(10.0f, 0.05f, -1.7f, PointClass::Ground, 0.0f);
  EXPECT_TRUE(scene.find(0.15).empty());
}

TEST(GroundContact, OfNoDistanceFindsNothing) {
  EXPECT_TRUE(randomScene().find(0.0).empty());
}

}  // namespace
}  // namespace toss::test
