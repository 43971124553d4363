// SPDX-License-Identifier: BSD-3-Clause
#include <toss/evaluation/NearestNeighbors.h>
#include <toss/evaluation/RemovalAccuracy.h>

#include <cmath>
#include <limits>

namespace toss {
namespace {

double percent(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? std::numeric_limits<double>::quiet_NaN()
                    : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

}  // namespace

void RemovalAccuracy::add(bool moving, bool kept) {
  if (moving) {
    ++movingPoints, movingRemoved += !kept;
  } else {
    ++staticPoints, staticKept += kept;
  }
}

double RemovalAccuracy::staticAccuracy() const {
  return percent(staticKept, staticPoints);
}
double RemovalAccuracy::dynamicAccuracy() const {
  return percent(movingRemoved, movingPoints);
}

double RemovalAccuracy::associatedAccuracy() const {
  return std::sqrt(staticAccuracy() * dynamicAccuracy());
}

double RemovalAccuracy::harmonicAccuracy() const {
  const double sum = staticAccuracy() + dynamicAccuracy();
  return sum == 0.0 ? 0.0 : 2.0 * staticAccuracy() * dynamicAccuracy() / sum;
}

LabelRemovalAccuracy::LabelRemovalAccuracy(double removalDistance, double cellSize)
    : removalDistance_(removalDistance), cellSize_(cellSize) {}

void LabelRemovalAccuracy::add(float x, float y, float z, bool moving, bool kept) {
  if (kept) {
    kept_.add(moving, true);
  } else {
    removed_.add(x, y, z, moving);
  }
}

void LabelRemovalAccuracy::endFirstPass() {
  orderByCell(removed_, cellSize_, removedOrder_);
  near_.assign(removedOrder_.places(), 0);
}

void LabelRemovalAccuracy::addKept(const CellOrder& kept) {
  const double limit = removalDistance_ * removalDistance_;
  joinCells(kept, removedOrder_, [&](std::size_t cell, std::uint32_t first, std::uint32_t end) {
    for (std::uint32_t r = first; r < end; ++r) {
      for (std::uint32_t k = kept.begin[cell]; !near_[r] && k < kept.begin[cell + 1]; ++k) {
        near_[r] = squaredDistance(kept.x[k], kept.y[k], kept.z[k], removedOrder_.x[r],
                                   removedOrder_.y[r], removedOrder_.z[r]) <= limit;
      }
    }
  });
}

RemovalAccuracy LabelRemovalAccuracy::result() const {
  RemovalAccuracy result = kept_;
  for (std::size_t r = 0; r < near_.size(); ++r) {
    result.add(removed_.label[removedOrder_.index[r]] != 0, near_[r] != 0);
  }
  return result;
}

}  // namespace toss
