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

/// A hair more, for rounding.
float padded(float reach) {
  return 1.001f * reach + 1e-4f;
}

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

std::int32_t GroundContact::enterCell(int row, int column) {
  const std::size_t place = gridIndex(row, column, kCells);
  std::int32_t& cell = cellAt_[place];
  if (cell >= 0) return cell;
  cell = static_cast<std::int32_t>(placeOfCell_.size());
  placeOfCell_.push_back(place), lastOfCell_.push_back(-1);
  for (int r = row - 1; r <= row + 1; ++r)
    for (int c = column - 1; c <= column + 1; ++c) reached_.set(gridIndex(r, c, kCells));
  return cell;
}

void GroundContact::enterPoint(const FootPoint& point) {
  const std::int32_t cell = enterCell(cellOf(point.x), cellOf(point.y));
  std::int32_t& last = lastOfCell_[static_cast<std::size_t>(cell)];
  const double x = point.x, y = point.y;
  const auto range = static_cast<float>(std::sqrt(x * x + y * y));
  const float same = kThinning * std::min(distance_, kReachPerRange * range);
  for (std::int32_t f = last; f >= 0; f = previous_[static_cast<std::size_t>(f)]) {
    const FootPoint& other = feet_[static_cast<std::size_t>(f)];
    const float dx = other.x - point.x, dy = other.y - point.y;
    if (other.claimant == point.claimant && dx * dx + dy * dy < same * same) return;
  }
  feet_.push_back(point), previous_.push_back(last);
  last = static_cast<std::int32_t>(feet_.size()) - 1;
}

void GroundContact::sortByCell() {
  sorted_.clear(), cellBegin_.clear();
  for (const std::int32_t last : lastOfCell_) {
    cellBegin_.push_back(static_cast<std::int32_t>(sorted_.size()));
    for (std::int32_t f = last; f >= 0; f = previous_[static_cast<std::size_t>(f)])
      sorted_.push_back(feet_[static_cast<std::size_t>(f)]);
  }
  cellBegin_.push_back(static_cast<std::int32_t>(sorted_.size()));
}

/// Returns of instances in the lowest half metre, by ascending point.
void GroundContact::pickFeet(const Segmentation& segmentation) {
  const std::size_t n = segmentation.pointClass.size();
  if (picked_.size() < n) picked_.resize(n);
  const PointClass* const pointClass = segmentation.pointClass.data();
  const float* const height = segmentation.heightAboveGround.data();
  std::int32_t* const picked = picked_.data();
  std::size_t count = 0;
  // Without branches, as no one could foretell which returns lie low.
  for (std::size_t i = 0; i < n; ++i) {
    picked[count] = static_cast<std::int32_t>(i);
    count += static_cast<std::size_t>((pointClass[i] == PointClass::Instance) &
                                      (height[i] < kFootHeight));
  }
  pickedCount_ = count;
}

void GroundContact::take(const LevelPoints& points, const Segmentation& segmentation,
                         const std::vector<Body>& bodies) {
  cellAt_.resize(kTable, -1);
  for (const std::size_t place : placeOfCell_) cellAt_[place] = -1;
  placeOfCell_.clear(), lastOfCell_.clear();
  feet_.clear(), previous_.clear();
  reached_.reset();
  pickedCount_ = 0;
  if (distance_ > 0.0f && !bodies.empty()) pickFeet(segmentation);
  bodyOf_.assign(static_cast<std::size_t>(segmentation.instanceCount) + 1, -1);
  extents_.assign(bodies.size(), Eigen::AlignedBox2f());
  for (std::size_t b = 0; b < bodies.size(); ++b)
    bodyOf_[static_cast<std::size_t>(bodies[b].instance)] = static_cast<std::int32_t>(b);
  for (std::size_t p = 0; p < pickedCount_; ++p) {
    const auto i = static_cast<std::size_t>(picked_[p]);
    const std::int32_t body = bodyOf_[static_cast<std::size_t>(segmentation.instance[i])];
    if (body < 0) continue;
    const auto b = static_cast<std::size_t>(body);
    extents_[b].extend(Eigen::Vector2f(points.x[i], points.y[i]));
    enterPoint({points.x[i], points.y[i], points.z[i], bodies[b].claimant});
  }
  sortByCell();
}

void GroundContact::markNearby(NearbyReturns& nearby) const {
  const Eigen::Vector2f reach = Eigen::Vector2f::Constant(padded(distance_));
  for (const Eigen::AlignedBox2f& feet : extents_)
    if (!feet.isEmpty())
      nearby.mark({feet.min() - reach, feet.max() + reach}, NearbyReturns::Of::NoInstance);
}

std::int32_t GroundContact::nearest(float x, float y, float z) const {
  const float range = std::sqrt(x * x + y * y);
  const float reach = std::min(distance_, std::max(kLeastReach, kReachPerRange * range));
  float best = reach * reach;
  std::int32_t claimant = -1;
  const int lastRow = cellOf(x + padded(reach)), lastColumn = cellOf(y + padded(reach));
  for (int r = cellOf(x - padded(reach)); r <= lastRow; ++r)
    for (int c = cellOf(y - padded(reach)); c <= lastColumn; ++c) {
      const std::int32_t cell = cellAt_[gridIndex(r, c, kCells)];
      if (cell < 0) continue;
      const std::int32_t* const begin = &cellBegin_[static_cast<std::size_t>(cell)];
      for (std::int32_t f = begin[0]; f < begin[1]; ++f) {
        const FootPoint& foot = sorted_[static_cast<std::size_t>(f)];
        const float dx = foot.x - x, dy = foot.y - y;
        const float squared = dx * dx + dy * dy;
        // Without branches, as no one could foretell which foot is nearer.
        const bool nearer = (squared < best) & (std::fabs(foot.z - z) < kFootHeight);
        best = nearer ? squared : best;
        claimant = nearer ? foot.claimant : claimant;
      }
    }
  return claimant;
}

void GroundContact::find(const LevelPoints& points, const Segmentation& segmentation,
                         const NearbyReturns& nearby, std::vector<BoxClaims::Claim>& claims) {
  claims.clear();
  if (picked_.size() < nearby.size()) picked_.resize(nearby.size());
  std::size_t count = 0;
  for (const std::int32_t point : nearby) {
    const auto i = static_cast<std::size_t>(point);
    picked_[count] = point;
    const std::size_t place = gridIndex(cellOf(points.x[i]), cellOf(points.y[i]), kCells);
    count += static_cast<std::size_t>((segmentation.pointClass[i] == PointClass::Ground) &
                                      reached_[place]);
  }
  for (std::size_t p = 0; p < count; ++p) {
    const auto i = static_cast<std::size_t>(picked_[p]);
    const std::int32_t claimant = nearest(points.x[i], points.y[i], points.z[i]);
    if (claimant >= 0) claims.push_back({picked_[p], claimant});
  }
}

}  // namespace toss
