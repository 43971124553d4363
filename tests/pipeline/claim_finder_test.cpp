// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <random>

#include "ClaimFinder.h"

namespace toss::test {
namespace {

constexpr double kMargin = 0.15, kBelow = 1.0;

/// Returns of all kinds and owners, strewn around boxes of all sizes and headings.
struct ClaimScene {
  ScanRecord record;
  std::vector<Claimant> claimants;
  std::vector<bool> moving{false, false, true};
};

ClaimScene randomScene(unsigned seed) {
  ClaimScene scene;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> anywhere(-15.0, 15.0), edge(0.3, 4.0), yaw(-1.5, 1.5);
  std::uniform_real_distribution<float> place(-17.0f, 17.0f), z(-3.5f, 2.5f);
  std::uniform_int_distribution<std::size_t> kind(0, 4);
  scene.record.sensorPosition = {100.0, -50.0, 3.0};
  scene.record.owners.resize(3);
  for (int c = 0; c < 40; ++c) {
    Box box;
    box.center =
        scene.record.sensorPosition + Eigen::Vector3d(anywhere(random), anywhere(random), 0);
    box.length = edge(random), box.width = edge(random), box.height = edge(random);
    box.yaw = yaw(random);
    scene.claimants.push_back({static_cast<TrackId>(c + 1), box, c % 2 == 0});
  }
  constexpr std::array<PointClass, 5> kClasses{PointClass::Ground, PointClass::Unclustered,
                                               PointClass::Instance, PointClass::Invalid,
                                               PointClass::OutOfRange};
  for (int i = 0; i < 20000; ++i) {
    const PointClass pointClass = kClasses[kind(random)];
    const bool owned = pointClass == PointClass::Instance;
    scene.record.level.x.push_back(place(random)), scene.record.level.y.push_back(place(random));
    scene.record.level.z.push_back(z(random));
    scene.record.pointClass.push_back(pointClass);
    scene.record.owner.push_back(static_cast<ScanRecord::OwnerIndex>(owned ? 1 + i % 2 : 0));
  }
  return scene;
}

std::map<std::int32_t, std::int32_t> claimsOf(const ClaimScene& scene, ClaimFinder& finder) {
  std::map<std::int32_t, std::int32_t> result;
  for (const Claim& claim : finder.find(scene.claimants, scene.record, scene.moving))
    result[claim.point] = claim.claimant;
  return result;
}

Eigen::Vector3d pointOf(const ScanRecord& record, std::size_t i) {
  return record.sensorPosition +
         Eigen::Vector3f(record.level.x[i], record.level.y[i], record.level.z[i]).cast<double>();
}

/// How far a point is inside the box with its margin and what lies below, below 0 outside.
double depthIn(const Box& box, const Eigen::Vector3d& point) {
  const Eigen::Vector3d d =
      Eigen::AngleAxisd(-box.yaw, Eigen::Vector3d::UnitZ()) * (point - box.center);
  return std::min({0.5 * box.length + kMargin - std::abs(d.x()),
                   0.5 * box.width + kMargin - std::abs(d.y()), 0.5 * box.height + kMargin - d.z(),
                   0.5 * box.height + kBelow + d.z()});
}

/// By comparison with all boxes; kUnsure where rounding decides.
constexpr std::int32_t kUnsure = -2;
std::int32_t claimantByAll(const ClaimScene& scene, std::size_t i) {
  const PointClass pointClass = scene.record.pointClass[i];
  const bool ground = pointClass == PointClass::Ground;
  const bool object = pointClass == PointClass::Unclustered || pointClass == PointClass::Instance;
  if (!(ground || object) || scene.moving[scene.record.owner[i]]) return -1;
  std::int32_t best = -1;
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t c = 0; c < scene.claimants.size(); ++c) {
    const Claimant& claimant = scene.claimants[c];
    if (ground && !claimant.ground) continue;
    const double depth = depthIn(claimant.box, pointOf(scene.record, i));
    if (std::abs(depth) < 1e-4) return kUnsure;
    if (depth < 0.0 || claimant.box.volume() >= smallest) continue;
    smallest = claimant.box.volume(), best = static_cast<std::int32_t>(c);
  }
  return best;
}

TEST(ClaimFinder, FindsWhatComparisonWithAllBoxesFinds) {
  ClaimFinder finder(kMargin);
  std::size_t ofGround = 0, ofObjects = 0;
  // The second time there are cells and marks of the first.
  for (const unsigned seed : {11u, 12u}) {
    const ClaimScene scene = randomScene(seed);
    const auto claims = claimsOf(scene, finder);
    for (std::size_t i = 0; i < scene.record.owner.size(); ++i) {
      const std::int32_t expected = claimantByAll(scene, i);
      if (expected == kUnsure) continue;
      const auto claim = claims.find(static_cast<std::int32_t>(i));
      ASSERT_EQ(claim == claims.end() ? -1 : claim->second, expected) << i;
      if (expected < 0) continue;
      ++(scene.record.pointClass[i] == PointClass::Ground ? ofGround : ofObjects);
    }
  }
  EXPECT_GT(ofGround, 300u);
  EXPECT_GT(ofObjects, 1000u);
}

TEST(ClaimFinder, FindsNothingWithoutBoxesOrReturns) {
  ClaimFinder finder(kMargin);
  ClaimScene scene = randomScene(11);
  EXPECT_FALSE(claimsOf(scene, finder).empty());
  scene.claimants.clear();
  EXPECT_TRUE(claimsOf(scene, finder).empty());
  scene = randomScene(11);
  scene.record = ScanRecord();
  EXPECT_TRUE(claimsOf(scene, finder).empty());
}

TEST(ClaimFinder, FindsReturnsBeyondItsGridAndNoneThatAreNotThere) {
  ClaimScene scene;
  scene.record.owners.resize(1);
  constexpr float kNowhere = std::numeric_limits<float>::quiet_NaN();
  const std::array<float, 4> along{400.0f, kNowhere, -400.0f, 0.0f};
  for (const float x : along) {
    scene.record.level.x.push_back(x), scene.record.level.y.push_back(x);
    scene.record.level.z.push_back(0.0f);
    scene.record.pointClass.push_back(PointClass::Unclustered);
    scene.record.owner.push_back(0);
  }
  Box box;
  box.length = box.width = box.height = 2.0;
  for (const double x : {400.0, -400.0}) {
    box.center = {x, x, 0.0};
    scene.claimants.push_back({1, box});
  }
  ClaimFinder finder(kMargin);
  EXPECT_EQ(claimsOf(scene, finder), (std::map<std::int32_t, std::int32_t>{{0, 0}, {2, 1}}));
}

}  // namespace
}  // namespace toss::test
