// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <vector>

#include "BoxClaims.h"

namespace toss::test {
namespace {

using Takes = BoxClaims::Claimant::Takes;

constexpr double kClaim = 0.15, kResidue = 0.4, kResidueHeight = 0.02;
constexpr std::int32_t kInstances = 12;

/// Returns of all kinds, strewn around boxes of all sizes and headings.
struct ClaimScene {
  LevelPoints points;
  Segmentation segmentation;
  std::vector<BoxClaims::Claimant> claimants;
  std::vector<bool> standing;

  std::map<std::int32_t, BoxClaims::Claim> find() const {
    BoxClaims claims({kClaim, kResidue}, kResidueHeight);
    claims.take(claimants, Eigen::Vector3d::Zero());
    std::map<std::int32_t, BoxClaims::Claim> result;
    for (const BoxClaims::Claim& claim : claims.find(points, segmentation, standing))
      result[claim.point] = claim;
    return result;
  }
};

ClaimScene randomScene() {
  ClaimScene scene;
  std::mt19937 random(11);
  std::uniform_real_distribution<double> anywhere(-15.0, 15.0), edge(0.3, 4.0), yaw(-1.5, 1.5);
  std::uniform_real_distribution<float> place(-17.0f, 17.0f), z(-2.5f, 2.0f), height(0.0f, 0.05f);
  std::uniform_int_distribution<std::int32_t> kind(0, 2), instance(1, kInstances);
  for (std::int32_t c = 0; c < 40; ++c) {
    Box box;
    box.center = {anywhere(random), anywhere(random), 0.0};
    box.length = edge(random), box.width = edge(random), box.height = edge(random);
    box.yaw = yaw(random);
    scene.claimants.push_back({box, static_cast<Takes>(c % 3), c < kInstances - 2 ? c + 1 : 0});
  }
  for (std::int32_t k = 0; k <= kInstances; ++k) scene.standing.push_back(k % 4 != 0);
  constexpr std::array<PointClass, 3> kClasses{PointClass::Ground, PointClass::Unclustered,
                                               PointClass::Instance};
  for (int i = 0; i < 20000; ++i) {
    const PointClass pointClass = kClasses[static_cast<std::size_t>(kind(random))];
    scene.points.x.push_back(place(random)), scene.points.y.push_back(place(random));
    scene.points.z.push_back(z(random));
    scene.segmentation.pointClass.push_back(pointClass);
    scene.segmentation.heightAboveGround.push_back(height(random));
    scene.segmentation.instance.push_back(pointClass == PointClass::Instance ? instance(random)
                                                                             : 0);
  }
  return scene;
}

/// Smallest box that holds the point when grown to its sides and top; it reaches a metre down.
std::int32_t smallestByAll(const ClaimScene& scene, const Eigen::Vector3d& point, double margin,
                           Takes least) {
  std::int32_t best = -1;
  for (std::size_t c = 0; c < scene.claimants.size(); ++c) {
    const Box& box = scene.claimants[c].box;
    const Eigen::Rotation2Dd boxFromLevel(-box.yaw);
    const Eigen::Vector2d flat = boxFromLevel * (point - box.center).head<2>();
    const double up = point.z() - box.center.z();
    const bool holds = std::fabs(flat.x()) <= box.length / 2 + margin &&
                       std::fabs(flat.y()) <= box.width / 2 + margin &&
                       up <= box.height / 2 + margin && up >= -box.height / 2 - 1.0;
    if (!holds || scene.claimants[c].takes < least) continue;
    if (best < 0 || box.volume() < scene.claimants[static_cast<std::size_t>(best)].box.volume())
      best = static_cast<std::int32_t>(c);
  }
  return best;
}

Eigen::AlignedBox2d around(const Box& box, double margin) {
  Eigen::AlignedBox2d extent;
  for (const double x : {-0.5, 0.5})
    for (const double y : {-0.5, 0.5}) {
      const Eigen::Vector2d corner(x * (box.length + 2 * margin), y * (box.width + 2 * margin));
      extent.extend((box.center.head<2>() + Eigen::Rotation2Dd(box.yaw) * corner).eval());
    }
  return extent;
}

/// Whether the rectangle around the box of instance k meets that of another that takes anything.
bool isMet(const ClaimScene& scene, std::int32_t k) {
  for (const BoxClaims::Claimant& own : scene.claimants) {
    if (own.instance != k) continue;
    return std::any_of(scene.claimants.begin(), scene.claimants.end(), [&](const auto& other) {
      const double margin = other.takes == Takes::Residue ? kResidue : kClaim;
      return other.takes != Takes::Nothing && other.instance != k &&
             around(other.box, margin).intersects(around(own.box, 0.0));
    });
  }
  return true;
}

/// The claim by the rules one after another; claimant -1 = none.
BoxClaims::Claim claimByAll(const ClaimScene& scene, std::size_t i) {
  const Eigen::Vector3d point(scene.points.x[i], scene.points.y[i], scene.points.z[i]);
  const std::int32_t k = scene.segmentation.instance[i];
  const bool low = scene.segmentation.pointClass[i] == PointClass::Ground &&
                   scene.segmentation.heightAboveGround[i] <= static_cast<float>(kResidueHeight);
  if (k > 0 && !(scene.standing[static_cast<std::size_t>(k)] && isMet(scene, k))) return {0, -1};
  BoxClaims::Claim claim{static_cast<std::int32_t>(i), -1, k, false};
  if (!low)
    claim.claimant = smallestByAll(scene, point, kClaim, k > 0 ? Takes::Cuts : Takes::Nothing);
  if (claim.claimant < 0)
    claim.claimant = smallestByAll(scene, point, kResidue, Takes::Residue), claim.residue = true;
  if (claim.claimant >= 0 && k > 0 &&
      scene.claimants[static_cast<std::size_t>(claim.claimant)].instance == k)
    claim.claimant = -1;
  return claim;
}

TEST(BoxClaims, AreWhatComparisonWithAllBoxesFinds) {
  const ClaimScene scene = randomScene();
  const auto found = scene.find();
  std::array<int, 4> seen{};
  for (std::size_t i = 0; i < scene.points.x.size(); ++i) {
    const BoxClaims::Claim expected = claimByAll(scene, i);
    const auto claim = found.find(static_cast<std::int32_t>(i));
    ASSERT_EQ(claim != found.end(), expected.claimant >= 0) << i;
    if (expected.claimant < 0) continue;
    EXPECT_EQ(claim->second.claimant, expected.claimant) << i;
    EXPECT_EQ(claim->second.host, expected.host) << i;
    EXPECT_EQ(claim->second.residue, expected.residue) << i;
    ++seen[static_cast<std::size_t>((expected.host > 0 ? 2 : 0) + (expected.residue ? 1 : 0))];
  }
  for (const int count : seen) EXPECT_GT(count, 50);
}

TEST(BoxClaims, OfNoResidueMarginLeaveLowGround) {
  ClaimScene scene = randomScene();
  BoxClaims claims({kClaim, 0.0}, kResidueHeight);
  claims.take(scene.claimants, Eigen::Vector3d::Zero());
  const BoxClaims::Claims found = claims.find(scene.points, scene.segmentation, scene.standing);
  EXPECT_GT(found.size(), 100u);
  for (const BoxClaims::Claim& claim : found) EXPECT_FALSE(claim.residue);
}

TEST(BoxClaims, NamesTheSmallestOtherBoxAroundAPoint) {
  const auto boxOf = [](double edge) {
    Box box;
    box.center = {5.0, 0.0, 0.0};
    box.length = box.width = box.height = edge;
    return BoxClaims::Claimant{box, Takes::Nothing, 0};
  };
  BoxClaims claims({0.0, 0.0}, 0.0);
  claims.take({boxOf(1.0), boxOf(4.0), boxOf(2.0)}, Eigen::Vector3d::Zero());
  EXPECT_EQ(claims.boxAround({5.0f, 0.2f, 0.0f}, -1), 0);
  EXPECT_EQ(claims.boxAround({5.0f, 0.2f, 0.0f}, 0), 2);
  EXPECT_EQ(claims.boxAround({5.0f, 1.8f, 0.0f}, 2), 1);
  EXPECT_EQ(claims.boxAround({5.0f, 2.2f, 0.0f}, -1), -1);
}

TEST(ClaimSquares, FindReturnsBeyondTheirGridAndNoneThatAreNotThere) {
  Box box;
  box.center = {150.5, 0.0, 0.0};
  box.length = box.width = box.height = 1.0;
  ClaimSquares squares;
  squares.clear();
  squares.mark(ClaimFootprint(box, Eigen::Vector3d::Zero(), 0.0), {});
  const float unknown = std::nanf("");
  const LevelPoints points{
      {150.5f, 0.0f, unknown, 150.5f}, {0.0f, 0.0f, unknown, 0.0f}, {0.0f, 0.0f, unknown, 0.0f}};
  Segmentation segmentation;
  segmentation.pointClass = {PointClass::Ground, PointClass::Ground, PointClass::Invalid,
                             PointClass::Instance};
  segmentation.instance = {0, 0, 0, 1};
  segmentation.heightAboveGround = {0.1f, 0.1f, unknown, 1.0f};
  ClaimReturns found;
  squares.find(points, segmentation, 0.02f, {true, true}, found);
  ASSERT_EQ(found.count, 1u);
  EXPECT_EQ(found.point.front(), 0);
  EXPECT_EQ(found.stretchCount, 1u);
}

}  // namespace
}  // namespace toss::test
