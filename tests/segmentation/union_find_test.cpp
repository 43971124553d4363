// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <toss/segmentation/UnionFind.h>

#include <algorithm>
#include <random>
#include <utility>
#include <vector>

namespace toss {
namespace {

using Edges = std::vector<std::pair<std::int32_t, std::int32_t>>;

std::vector<std::int32_t> representatives(std::size_t n, const Edges& edges) {
  UnionFind sets(n);
  for (const auto& [a, b] : edges) sets.unite(a, b);
  std::vector<std::int32_t> result;
  for (std::size_t i = 0; i < n; ++i) result.push_back(sets.find(static_cast<std::int32_t>(i)));
  return result;
}

/// Smallest number reachable from each number, by passing labels along edges until nothing changes.
std::vector<std::int32_t> smallestReachable(std::size_t n, const Edges& edges) {
  std::vector<std::int32_t> label(n);
  for (std::size_t i = 0; i < n; ++i) label[i] = static_cast<std::int32_t>(i);
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto& [a, b] : edges) {
      auto &x = label[static_cast<std::size_t>(a)], &y = label[static_cast<std::size_t>(b)];
      changed |= x != y;
      x = y = std::min(x, y);
    }
  }
  return label;
}

TEST(UnionFind, StartsWithOneSetPerMember) {
  UnionFind sets(3);
  EXPECT_EQ(sets.size(), 3u);
  for (std::int32_t i = 0; i < 3; ++i) EXPECT_EQ(sets.find(i), i);
}

TEST(UnionFind, TellsWhetherTwoSetsBecameOne) {
  UnionFind sets(3);
  EXPECT_TRUE(sets.unite(2, 1));
  EXPECT_FALSE(sets.unite(1, 2));
  EXPECT_TRUE(sets.unite(0, 2));
  EXPECT_FALSE(sets.unite(0, 1));
}

TEST(UnionFind, RepresentativeIsTheSmallestMemberInAnyOrderOfUnions) {
  std::mt19937 random(7);
  for (std::size_t n : {10u, 200u, 3000u}) {
    std::uniform_int_distribution<std::int32_t> any(0, static_cast<std::int32_t>(n) - 1);
    Edges edges(n * 2 / 3);
    for (auto& edge : edges) edge = {any(random), any(random)};
    const std::vector<std::int32_t> expected = smallestReachable(n, edges);
    for (int repeat = 0; repeat < 5; ++repeat) {
      std::shuffle(edges.begin(), edges.end(), random);
      ASSERT_EQ(representatives(n, edges), expected);
    }
  }
}

TEST(UnionFind, ResetForgetsUnions) {
  UnionFind sets(4);
  sets.unite(0, 3);
  sets.reset(5);
  EXPECT_EQ(sets.size(), 5u);
  EXPECT_EQ(sets.find(3), 3);
}

}  // namespace
}  // namespace toss
