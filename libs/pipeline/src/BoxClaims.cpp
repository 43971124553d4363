// SPDX-License-Identifier: BSD-3-Clause
#include "BoxClaims.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace toss {
namespace {

using Takes = BoxClaims::Claimant::Takes;

constexpr int kCells = 256;
constexpr float kCellSize = 1.0f;
/// The lowest part of an object lies in the ground layer or is too sparse to be in its instance.
constexpr double kBelowBox = 1.0;

/// Cell along one axis; -1 and kCells stand for all beyond the grid.
int cellOf(float coordinate) {
  const float cell = coordinate * (1.0f / kCellSize) + (0.5f * kCells + 1.0f);
  return static_cast<int>(std::clamp(cell, 0.0f, kCells + 1.0f)) - 1;
}

bool isInside(int cell) {
  return cell >= 0 && cell < kCells;
}

std::size_t gridIndex(int row, int column) {
  return static_cast<std::size_t>(row) * kCells + static_cast<std::size_t>(column);
}

/// Calls `visit(index)` for each cell of the grid that an area of the level frame meets.
template <typename Visit>
void visitCells(const Eigen::AlignedBox2f& area, Visit&& visit) {
  const int lastRow = cellOf(area.max().x()), lastColumn = cellOf(area.max().y());
  for (int row = cellOf(area.min().x()); row <= lastRow; ++row)
    for (int column = cellOf(area.min().y()); column <= lastColumn; ++column)
      if (isInside(row) && isInside(column)) visit(gridIndex(row, column));
}

}  // namespace

Eigen::AlignedBox2f BoxClaims::Footprint::extent(float margin) const {
  const float length = halfLength + margin, width = halfWidth + margin;
  const Eigen::Vector2f reach(length * std::fabs(cosYaw) + width * std::fabs(sinYaw),
                              length * std::fabs(sinYaw) + width * std::fabs(cosYaw));
  const Eigen::Vector2f middle(x, y);
  return {middle - reach, middle + reach};
}

inline bool BoxClaims::Footprint::holds(const Eigen::Vector3f& point, float margin) const {
  const float dx = point.x() - x, dy = point.y() - y;
  // Without branches, as no one could foretell them.
  return static_cast<bool>((point.z() >= low) & (point.z() <= high + margin) &
                           (std::fabs(cosYaw * dx + sinYaw * dy) <= halfLength + margin) &
                           (std::fabs(cosYaw * dy - sinYaw * dx) <= halfWidth + margin));
}

float BoxClaims::reachOf(const Footprint& footprint) const {
  return static_cast<float>(footprint.takes == Takes::Residue
                                ? std::max(margins_.claim, margins_.residue)
                                : margins_.claim);
}

void BoxClaims::enter(const Claimant& claimant, std::int32_t number,
                      const Eigen::Vector3d& sensorPosition) {
  const Box& box = claimant.box;
  const Eigen::Vector3f center = (box.center - sensorPosition).cast<float>();
  Footprint& f = footprints_[static_cast<std::size_t>(number)];
  f.takes = claimant.takes;
  f.instance = claimant.instance;
  f.x = center.x(), f.y = center.y();
  f.cosYaw = static_cast<float>(std::cos(box.yaw)),
  f.sinYaw = static_cast<float>(std::sin(box.yaw));
  f.halfLength = static_cast<float>(0.5 * box.length);
  f.halfWidth = static_cast<float>(0.5 * box.width);
  f.low = center.z() - static_cast<float>(0.5 * box.height + kBelowBox);
  f.high = center.z() + static_cast<float>(0.5 * box.height);
  f.claimed = f.extent(reachOf(f));
  visitCells(f.claimed, [&](std::size_t index) {
    Cell& cell = grid_[index];
    if (cell.first < 0) usedCells_.push_back(index);
    entries_.push_back({number, cell.first});
    cell.first = static_cast<std::int32_t>(entries_.size()) - 1;
    cell.most = std::max(cell.most, claimant.takes);
  });
}

void BoxClaims::take(const std::vector<Claimant>& claimants,
                     const Eigen::Vector3d& sensorPosition) {
  grid_.resize(static_cast<std::size_t>(kCells) * kCells);
  for (const std::size_t cell : usedCells_) grid_[cell] = Cell();
  usedCells_.clear(), entries_.clear();
  footprints_.resize(claimants.size());
  // Entered last means found first: larger boxes go in before smaller ones.
  std::vector<std::int32_t> order(claimants.size());
  std::iota(order.begin(), order.end(), 0);
  const auto volume = [&](std::int32_t c) {
    return claimants[static_cast<std::size_t>(c)].box.volume();
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::int32_t a, std::int32_t b) { return volume(a) > volume(b); });
  for (const std::int32_t number : order)
    enter(claimants[static_cast<std::size_t>(number)], number, sensorPosition);
}

void BoxClaims::markNearby(NearbyReturns& nearby) const {
  for (const Footprint& footprint : footprints_) {
    nearby.mark(footprint.claimed, NearbyReturns::Of::NoInstance);
    if (footprint.takes != Takes::Nothing)
      nearby.mark(footprint.claimed, NearbyReturns::Of::Instances);
  }
}

bool BoxClaims::isMet(std::size_t number) const {
  const Eigen::AlignedBox2f own = footprints_[number].extent(0.0f);
  bool met = false;
  visitCells(own, [&](std::size_t index) {
    for (std::int32_t e = grid_[index].first; e >= 0 && !met;
         e = entries_[static_cast<std::size_t>(e)].next) {
      const auto other = static_cast<std::size_t>(entries_[static_cast<std::size_t>(e)].box);
      const Footprint& f = footprints_[other];
      met = other != number && f.takes != Takes::Nothing && f.claimed.intersects(own);
    }
  });
  return met;
}

std::int32_t BoxClaims::claimOf(const Eigen::Vector3f& point, float margin, Takes least,
                                std::int32_t except) const {
  const int row = cellOf(point.x()), column = cellOf(point.y());
  if (!isInside(row) || !isInside(column)) return -1;
  const Cell& cell = grid_[gridIndex(row, column)];
  if (cell.most < least) return -1;
  for (std::int32_t e = cell.first; e >= 0; e = entries_[static_cast<std::size_t>(e)].next) {
    const std::int32_t box = entries_[static_cast<std::size_t>(e)].box;
    const Footprint& f = footprints_[static_cast<std::size_t>(box)];
    if (f.takes < least || box == except) continue;
    if (f.holds(point, margin)) return box;
  }
  return -1;
}

std::int32_t BoxClaims::residueOf(const Eigen::Vector3f& point) const {
  if (margins_.residue == 0.0) return -1;
  return claimOf(point, static_cast<float>(margins_.residue), Takes::Residue, -1);
}

BoxClaims::Claim BoxClaims::claimOutside(const Eigen::Vector3f& point, bool low) const {
  const auto margin = static_cast<float>(margins_.claim);
  const std::int32_t claimant = low ? -1 : claimOf(point, margin, Takes::Nothing, -1);
  if (claimant >= 0) return {0, claimant, 0, false};
  return {0, residueOf(point), 0, true};
}

BoxClaims::Claim BoxClaims::claimInside(const Eigen::Vector3f& point, std::int32_t host) const {
  Claim claim{0, claimOf(point, static_cast<float>(margins_.claim), Takes::Cuts, -1), host, false};
  if (claim.claimant < 0) claim.claimant = residueOf(point), claim.residue = true;
  const bool own =
      claim.claimant >= 0 && footprints_[static_cast<std::size_t>(claim.claimant)].instance == host;
  if (own) claim.claimant = -1;
  return claim;
}

void BoxClaims::find(const LevelPoints& points, const Segmentation& segmentation,
                     const NearbyReturns& nearby, const std::vector<bool>& standing,
                     std::vector<Claim>& claims) {
  claims.clear();
  cuttable_ = standing;
  for (std::size_t c = 0; c < footprints_.size(); ++c)
    if (const auto own = static_cast<std::size_t>(footprints_[c].instance); own != 0)
      cuttable_[own] = cuttable_[own] && isMet(c);
  const auto residueHeight = static_cast<float>(residueHeight_);
  for (const std::int32_t number : nearby) {
    const auto i = static_cast<std::size_t>(number);
    const Eigen::Vector3f point(points.x[i], points.y[i], points.z[i]);
    const std::int32_t host = segmentation.instance[i];
    Claim claim{0, -1};
    if (segmentation.pointClass[i] == PointClass::Instance) {
      if (cuttable_[static_cast<std::size_t>(host)]) claim = claimInside(point, host);
    } else {
      const bool low = segmentation.pointClass[i] == PointClass::Ground &&
                       segmentation.heightAboveGround[i] <= residueHeight;
      claim = claimOutside(point, low);
    }
    claim.point = number;
    if (claim.claimant >= 0) claims.push_back(claim);
  }
}

std::int32_t BoxClaims::boxAround(const Eigen::Vector3f& point, std::int32_t except) const {
  return claimOf(point, static_cast<float>(margins_.claim), Takes::Nothing, except);
}

}  // namespace toss
