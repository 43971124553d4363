// SPDX-License-Identifier: BSD-3-Clause
#include "BoxClaims.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace toss {
namespace {

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

}  // namespace

Eigen::AlignedBox2f BoxClaims::Footprint::extent() const {
  const float reachX = halfLength * std::fabs(cosYaw) + halfWidth * std::fabs(sinYaw);
  const float reachY = halfLength * std::fabs(sinYaw) + halfWidth * std::fabs(cosYaw);
  const Eigen::Vector2f middle(x, y), reach(reachX, reachY);
  return {middle - reach, middle + reach};
}

inline bool BoxClaims::Footprint::holds(float px, float py, float pz) const {
  const float dx = px - x, dy = py - y;
  // Without branches, as no one could foretell them.
  return static_cast<bool>((pz >= low) & (pz <= high) &
                           (std::fabs(cosYaw * dx + sinYaw * dy) <= halfLength) &
                           (std::fabs(cosYaw * dy - sinYaw * dx) <= halfWidth));
}

void BoxClaims::enter(const Claimant& claimant, std::int32_t number,
                      const Eigen::Vector3d& sensorPosition) {
  const Box& box = claimant.box;
  const double margin = claimant.cutsInstances ? 0.0 : margin_;
  const Eigen::Vector3f center = (box.center - sensorPosition).cast<float>();
  Footprint& f = footprints_[static_cast<std::size_t>(number)];
  f.cutsInstances = claimant.cutsInstances;
  f.x = center.x(), f.y = center.y();
  f.cosYaw = static_cast<float>(std::cos(box.yaw)),
  f.sinYaw = static_cast<float>(std::sin(box.yaw));
  f.halfLength = static_cast<float>(0.5 * box.length + margin);
  f.halfWidth = static_cast<float>(0.5 * box.width + margin);
  f.low = center.z() - static_cast<float>(0.5 * box.height + kBelowBox);
  f.high = center.z() + static_cast<float>(0.5 * box.height + margin);
  const Eigen::AlignedBox2f extent = f.extent();
  const int lastRow = cellOf(extent.max().x()), lastColumn = cellOf(extent.max().y());
  for (int row = cellOf(extent.min().x()); row <= lastRow; ++row)
    for (int column = cellOf(extent.min().y()); column <= lastColumn; ++column) {
      if (!isInside(row) || !isInside(column)) continue;
      std::int32_t& head = grid_[gridIndex(row, column)];
      if (head < 0) usedCells_.push_back(gridIndex(row, column));
      entries_.push_back({number, head});
      head = static_cast<std::int32_t>(entries_.size()) - 1;
    }
}

void BoxClaims::take(const std::vector<Claimant>& claimants,
                     const Eigen::Vector3d& sensorPosition) {
  grid_.resize(static_cast<std::size_t>(kCells) * kCells, -1);
  for (const std::size_t cell : usedCells_) grid_[cell] = -1;
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
    nearby.mark(footprint.extent(), NearbyReturns::Of::NoInstance);
    if (footprint.cutsInstances) nearby.mark(footprint.extent(), NearbyReturns::Of::Instances);
  }
}

/// Without branches, as no one could foretell on which side of the residue's height a return lies.
void BoxClaims::pickClaimable(const Segmentation& segmentation, const NearbyReturns& nearby,
                              const std::vector<bool>& standing) {
  const auto residue = static_cast<float>(residueHeight_);
  claimable_.resize(nearby.size());
  std::size_t count = 0;
  for (const std::int32_t point : nearby) {
    const auto i = static_cast<std::size_t>(point);
    const PointClass pointClass = segmentation.pointClass[i];
    claimable_[count] = point;
    count += static_cast<std::size_t>(
        (pointClass == PointClass::Unclustered) |
        ((pointClass == PointClass::Ground) & (segmentation.heightAboveGround[i] > residue)) |
        ((pointClass == PointClass::Instance) &
         standing[static_cast<std::size_t>(segmentation.instance[i])]));
  }
  claimable_.resize(count);
}

std::int32_t BoxClaims::claimOf(float x, float y, float z, bool fromInstance,
                                std::int32_t except) const {
  const int row = cellOf(x), column = cellOf(y);
  if (!isInside(row) || !isInside(column)) return -1;
  for (std::int32_t e = grid_[gridIndex(row, column)]; e >= 0;
       e = entries_[static_cast<std::size_t>(e)].next) {
    const std::int32_t box = entries_[static_cast<std::size_t>(e)].box;
    const Footprint& f = footprints_[static_cast<std::size_t>(box)];
    if ((fromInstance && !f.cutsInstances) || box == except) continue;
    if (f.holds(x, y, z)) return box;
  }
  return -1;
}

void BoxClaims::find(const LevelPoints& points, const Segmentation& segmentation,
                     const NearbyReturns& nearby, const std::vector<bool>& standing,
                     std::vector<Claim>& claims) {
  pickClaimable(segmentation, nearby, standing);
  claims.clear();
  for (const std::int32_t point : claimable_) {
    const auto i = static_cast<std::size_t>(point);
    const bool fromInstance = segmentation.pointClass[i] == PointClass::Instance;
    const std::int32_t claimant = claimOf(points.x[i], points.y[i], points.z[i], fromInstance, -1);
    if (claimant >= 0) claims.push_back({point, claimant});
  }
}

std::int32_t BoxClaims::boxAround(const Eigen::Vector3f& point, std::int32_t except) const {
  return claimOf(point.x(), point.y(), point.z(), false, except);
}

}  // namespace toss
