// SPDX-License-Identifier: BSD-3-Clause
#include "GroundContact.h"

#include <algorithm>
#include <cmath>

namespace toss {
namespace {

/// The part of a body that can touch the ground [m].
constexpr float kFootHeight = 0.5f;
/// Feet are sampled at the spacing of beams: their reach grows with range, in metres per metre,
/// from the thickness of a shoe on.
constexpr float kReachPerRange = 0.012f, kLeastReach = 0.03f;
/// Foot points nearer to each other than this share of the reach say the same.
constexpr float kThinning = 0.25f;

std::size_t gridIndex(int row, int column, int cells) {
  const int mask = cells - 1;
  return static_cast<std::size_t>(row & mask) * static_cast<std::size_t>(cells) +
         static_cast<std::size_t>(column & mask);
}

}  // namespace

int GroundContact::cellOf(float coordinate) const {
  // Shifted to where truncation rounds down, as calls of std::floor take longer than all the rest.
  constexpr double kShift = 1 << 20;
  return static_cast<int>(static_cast<double>(coordinate) * inverseDistance_ + kShift);
}

void GroundContact::enterPoint(const FootPoint& point) {
  const int row = cellOf(point.x), column = cellOf(point.y);
  std::int32_t& head = head_[gridIndex(row, column, kCells)];
  const float same = kThinning * std::min(distance_, kReachPerRange * std::hypot(point.x, point.y));
  for (std::int32_t f = head; f >= 0; f = feet_[static_cast<std::size_t>(f)].next) {
    const FootPoint& other = feet_[static_cast<std::size_t>(f)];
    const float dx = other.x - point.x, dy = other.y - point.y;
    if (other.claimant == point.claimant && dx * dx + dy * dy < same * same) return;
  }
  feet_.push_back(point);
  feet_.back().next = head;
  head = static_cast<std::int32_t>(feet_.size()) - 1;
  for (int r = row - 1; r <= row + 1; ++r)
    for (int c = column - 1; c <= column + 1; ++c) reached_.set(gridIndex(r, c, kCells));
}

void GroundContact::enter(const LevelPoints& points, const Segmentation& segmentation,
                          const Body& body) {
  const auto k = static_cast<std::size_t>(body.instance);
  for (std::int32_t m = segmentation.memberBegin[k - 1]; m < segmentation.memberBegin[k]; ++m) {
    const auto i = static_cast<std::size_t>(segmentation.members[static_cast<std::size_t>(m)]);
    if (segmentation.heightAboveGround[i] < kFootHeight)
      enterPoint({points.x[i], points.y[i], points.z[i], body.claimant, -1});
  }
}

std::int32_t GroundContact::nearest(float x, float y, float z) const {
  const int row = cellOf(x), column = cellOf(y);
  const float range = std::sqrt(x * x + y * y);
  const float reach = std::min(distance_, std::max(kLeastReach, kReachPerRange * range));
  float best = reach * reach;
  std::int32_t claimant = -1;
  for (int r = row - 1; r <= row + 1; ++r)
    for (int c = column - 1; c <= column + 1; ++c)
      for (std::int32_t f = head_[gridIndex(r, c, kCells)]; f >= 0;
           f = feet_[static_cast<std::size_t>(f)].next) {
        const FootPoint& foot = feet_[static_cast<std::size_t>(f)];
        const float dx = foot.x - x, dy = foot.y - y;
        const float squared = dx * dx + dy * dy;
        if (squared < best && std::fabs(foot.z - z) < kFootHeight)
          best = squared, claimant = foot.claimant;
      }
  return claimant;
}

void GroundContact::find(const LevelPoints& points, const Segmentation& segmentation,
                         const std::vector<Body>& bodies, std::vector<BoxClaims::Claim>& claims) {
  if (distance_ == 0.0f) return;
  head_.assign(static_cast<std::size_t>(kCells) * kCells, -1);
  reached_.reset();
  feet_.clear();
  for (const Body& body : bodies) enter(points, segmentation, body);
  for (std::size_t i = 0; i < points.x.size(); ++i) {
    if (segmentation.pointClass[i] != PointClass::Ground) continue;
    if (!reached_[gridIndex(cellOf(points.x[i]), cellOf(points.y[i]), kCells)]) continue;
    const std::int32_t claimant = nearest(points.x[i], points.y[i], points.z[i]);
    if (claimant >= 0) claims.push_back({static_cast<std::int32_t>(i), claimant});
  }
}

}  // namespace toss
