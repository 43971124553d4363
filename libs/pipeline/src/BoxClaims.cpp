// SPDX-License-Identifier: BSD-3-Clause
#include "BoxClaims.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace toss {
namespace {

constexpr int kCells = 512;
constexpr float kCellSize = 0.5f;
/// The lowest part of an object lies in the ground layer, below the box of its instance.
constexpr double kBelowBox = 0.4;

int cellOf(float coordinate) {
  const float cell = std::floor(coordinate / kCellSize) + 0.5f * kCells;
  return static_cast<int>(std::clamp(cell, -1.0f, static_cast<float>(kCells)));
}

bool isInside(int cell) {
  return cell >= 0 && cell < kCells;
}

std::size_t gridIndex(int row, int column) {
  return static_cast<std::size_t>(row) * kCells + static_cast<std::size_t>(column);
}

}  // namespace

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
  const float reachX = f.halfLength * std::fabs(f.cosYaw) + f.halfWidth * std::fabs(f.sinYaw);
  const float reachY = f.halfLength * std::fabs(f.sinYaw) + f.halfWidth * std::fabs(f.cosYaw);
  for (int row = cellOf(f.x - reachX); row <= cellOf(f.x + reachX); ++row)
    for (int column = cellOf(f.y - reachY); column <= cellOf(f.y + reachY); ++column) {
      if (!isInside(row) || !isInside(column)) continue;
      std::int32_t& head = grid_[gridIndex(row, column)];
      entries_.push_back({number, head});
      head = static_cast<std::int32_t>(entries_.size()) - 1;
    }
}

bool BoxClaims::isClaimable(const Segmentation& segmentation, std::size_t point) const {
  if (segmentation.pointClass[point] == PointClass::Unclustered) return true;
  return segmentation.pointClass[point] == PointClass::Ground &&
         segmentation.heightAboveGround[point] > static_cast<float>(residueHeight_);
}

std::int32_t BoxClaims::claimOf(float x, float y, float z, bool fromInstance) const {
  const int row = cellOf(x), column = cellOf(y);
  if (!isInside(row) || !isInside(column)) return -1;
  for (std::int32_t e = grid_[gridIndex(row, column)]; e >= 0;
       e = entries_[static_cast<std::size_t>(e)].next) {
    const std::int32_t box = entries_[static_cast<std::size_t>(e)].box;
    const Footprint& f = footprints_[static_cast<std::size_t>(box)];
    if (fromInstance && !f.cutsInstances) continue;
    const float dx = x - f.x, dy = y - f.y;
    if (z >= f.low && z <= f.high && std::fabs(f.cosYaw * dx + f.sinYaw * dy) <= f.halfLength &&
        std::fabs(f.cosYaw * dy - f.sinYaw * dx) <= f.halfWidth)
      return box;
  }
  return -1;
}

void BoxClaims::find(const LevelPoints& points, const Segmentation& segmentation,
                     const std::vector<Claimant>& claimants, const Eigen::Vector3d& sensorPosition,
                     const std::vector<bool>& standing, std::vector<std::int32_t>& claimOfPoint) {
  claimOfPoint.assign(segmentation.pointClass.size(), -1);
  grid_.assign(static_cast<std::size_t>(kCells) * kCells, -1);
  entries_.clear();
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
  for (std::size_t i = 0; i < claimOfPoint.size(); ++i) {
    const bool fromInstance = segmentation.pointClass[i] == PointClass::Instance &&
                              standing[static_cast<std::size_t>(segmentation.instance[i])];
    if (fromInstance || isClaimable(segmentation, i))
      claimOfPoint[i] = claimOf(points.x[i], points.y[i], points.z[i], fromInstance);
  }
}

}  // namespace toss
