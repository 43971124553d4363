// SPDX-License-Identifier: BSD-3-Clause
#include "BoxClaims.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
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
  const Eigen::Vector2f middle(f.x, f.y), reach(reachX, reachY);
  if (f.cutsInstances) cutExtent_.extend(middle - reach).extend(middle + reach);
  for (int row = cellOf(f.x - reachX); row <= cellOf(f.x + reachX); ++row)
    for (int column = cellOf(f.y - reachY); column <= cellOf(f.y + reachY); ++column) {
      if (!isInside(row) || !isInside(column)) continue;
      std::int32_t& head = grid_[gridIndex(row, column)];
      if (head < 0) usedCells_.push_back(gridIndex(row, column));
      entries_.push_back({number, head});
      head = static_cast<std::int32_t>(entries_.size()) - 1;
    }
}

void BoxClaims::enterAll(const std::vector<Claimant>& claimants,
                         const Eigen::Vector3d& sensorPosition) {
  grid_.resize(static_cast<std::size_t>(kCells) * kCells, -1);
  for (const std::size_t cell : usedCells_) grid_[cell] = -1;
  usedCells_.clear(), entries_.clear();
  cutExtent_.setEmpty();
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

void BoxClaims::collectOutsideInstances(const Segmentation& segmentation) {
  const PointClass* const pointClass = segmentation.pointClass.data();
  const float* const height = segmentation.heightAboveGround.data();
  const auto residue = static_cast<float>(residueHeight_);
  const std::size_t n = segmentation.pointClass.size();
  // Eight returns at a time, of most of which none may be claimed.
  for (std::size_t begin = 0; begin < n; begin += 8) {
    std::array<std::uint8_t, 8> may{};
    for (std::size_t i = begin; i < std::min(begin + 8, n); ++i)
      may[i - begin] = (pointClass[i] == PointClass::Unclustered) |
                       ((pointClass[i] == PointClass::Ground) & (height[i] > residue));
    std::uint64_t any;
    std::memcpy(&any, may.data(), sizeof(any));
    if (any == 0) continue;
    for (std::size_t i = 0; i < 8; ++i)
      if (may[i] != 0) claimable_.push_back(static_cast<std::int32_t>(begin + i));
  }
}

void BoxClaims::collectInInstances(const LevelPoints& points, const Segmentation& segmentation,
                                   const std::vector<bool>& standing) {
  for (std::size_t k = 1; k < standing.size(); ++k) {
    if (!standing[k]) continue;
    for (std::int32_t m = segmentation.memberBegin[k - 1]; m < segmentation.memberBegin[k]; ++m) {
      const std::int32_t point = segmentation.members[static_cast<std::size_t>(m)];
      const auto i = static_cast<std::size_t>(point);
      if (cutExtent_.contains(Eigen::Vector2f(points.x[i], points.y[i])))
        claimable_.push_back(point);
    }
  }
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
    const float dx = x - f.x, dy = y - f.y;
    if (z >= f.low && z <= f.high && std::fabs(f.cosYaw * dx + f.sinYaw * dy) <= f.halfLength &&
        std::fabs(f.cosYaw * dy - f.sinYaw * dx) <= f.halfWidth)
      return box;
  }
  return -1;
}

void BoxClaims::find(const LevelPoints& points, const Segmentation& segmentation,
                     const std::vector<Claimant>& claimants, const Eigen::Vector3d& sensorPosition,
                     const std::vector<bool>& standing, std::vector<Claim>& claims) {
  enterAll(claimants, sensorPosition);
  claimable_.clear();
  collectOutsideInstances(segmentation);
  if (!cutExtent_.isEmpty()) collectInInstances(points, segmentation, standing);
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
