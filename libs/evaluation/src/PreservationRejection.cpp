// SPDX-License-Identifier: BSD-3-Clause
#include <toss/evaluation/NearestNeighbors.h>
#include <toss/evaluation/PreservationRejection.h>
#include <toss/rawlog/LabelFile.h>

#include <cmath>
#include <limits>

namespace toss {
namespace {

double ratio(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? std::numeric_limits<double>::quiet_NaN()
                    : static_cast<double>(part) / static_cast<double>(whole);
}

std::vector<std::int32_t> inliers(const LabelledCloud& truth, const LabelledCloud& estimate,
                                  double voxelSize) {
  CellOrder truthOrder, estimateOrder;
  orderByCell(truth, voxelSize, truthOrder);
  orderByCell(estimate, voxelSize, estimateOrder);
  return nearestNeighbors(truthOrder, estimateOrder, voxelSize * std::sqrt(3.0) / 2.0,
                          truth.size());
}

void count(bool moving, bool same, PreservationRejection& score) {
  if (moving) {
    ++score.movingVoxels, score.movingLeft += same;
  } else {
    ++score.staticVoxels, score.staticKept += same;
  }
}

VoxelFate fateOf(bool moving, bool same) {
  if (moving) return same ? VoxelFate::Residue : VoxelFate::Removed;
  return same ? VoxelFate::Kept : VoxelFate::Lost;
}

std::vector<MapPoint>& listOf(VoxelFate fate, MapErrors& errors) {
  switch (fate) {
    case VoxelFate::Kept:
      return errors.kept;
    case VoxelFate::Lost:
      return errors.lost;
    case VoxelFate::Removed:
      return errors.removed;
    case VoxelFate::Residue:
      break;
  }
  return errors.residue;
}

}  // namespace

double PreservationRejection::preservationRate() const {
  return 100.0 * ratio(staticKept, staticVoxels);
}

double PreservationRejection::rejectionRate() const {
  return 100.0 * ratio(movingVoxels - movingLeft, movingVoxels);
}

double PreservationRejection::f1() const {
  const double preserved = ratio(staticKept, staticVoxels);
  const double rejected = ratio(movingVoxels - movingLeft, movingVoxels);
  const double sum = preserved + rejected;
  return sum == 0.0 ? 0.0 : 2.0 * preserved * rejected / sum;
}

MapComparison compareMaps(const LabelledCloud& truth, const LabelledCloud& estimate,
                          double voxelSize) {
  MapComparison result;
  result.nearest = inliers(truth, estimate, voxelSize);
  result.fate.resize(truth.size());
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const bool moving = label::isMoving(truth.label[i]);
    const std::int32_t e = result.nearest[i];
    const bool same =
        e >= 0 && label::isMoving(estimate.label[static_cast<std::size_t>(e)]) == moving;
    count(moving, same, result.score);
    result.fate[i] = fateOf(moving, same);
  }
  return result;
}

MapErrors mapErrors(const LabelledCloud& truth, const MapComparison& comparison,
                    const Eigen::Vector3d& origin) {
  MapErrors errors;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    MapPoint point;
    point.x = static_cast<float>(truth.x[i] + origin.x());
    point.y = static_cast<float>(truth.y[i] + origin.y());
    point.z = static_cast<float>(truth.z[i] + origin.z());
    listOf(comparison.fate[i], errors).push_back(point);
  }
  return errors;
}

}  // namespace toss
