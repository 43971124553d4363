// SPDX-License-Identifier: BSD-3-Clause
#include <toss/geometry/Error.h>
#include <toss/mapping/VoxelMap.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "VoxelBinning.h"
#include "VoxelTiles.h"

namespace toss {

namespace {

VoxelBinning& threadsBinning() {
  thread_local VoxelBinning binning;
  return binning;
}

}  // namespace

struct VoxelMap::Implementation {
  double voxelSize;
  Eigen::Vector3d origin;
  VoxelTiles tiles;

  MapPoint point(const VoxelSum& sum, const Eigen::Vector3d& offset) const;
  void checkReach(const Eigen::Vector3d& sensorPosition) const;
  VoxelReturns returns(const float* x, const float* y, const float* z,
                       const std::vector<float>& intensity,
                       const Eigen::Vector3d& sensorPosition) const;
};

VoxelMap::VoxelMap(double voxelSize, const Eigen::Vector3d& origin, double tileSize,
                   TileStore* store)
    : implementation_(
          new Implementation{voxelSize, origin, VoxelTiles(tileSize / voxelSize, store)}) {
  if (!(voxelSize > 0.0) || !std::isfinite(voxelSize)) {
    throw UserError("map.voxel_size", "is not a length above 0", "give the edge of a voxel in m");
  }
  if (!origin.allFinite()) throw std::logic_error("VoxelMap: origin is not finite");
}

VoxelMap::~VoxelMap() = default;

void VoxelMap::Implementation::checkReach(const Eigen::Vector3d& sensorPosition) const {
  const double reach = kVoxelReach * voxelSize;
  if ((sensorPosition - origin).cwiseAbs().maxCoeff() < reach && sensorPosition.allFinite()) return;
  throw UserError("map.voxel_size",
                  "the sensor is not within " + std::to_string(std::llround(reach)) +
                      " m of where the map began",
                  "check the poses, or raise it");
}

VoxelReturns VoxelMap::Implementation::returns(const float* x, const float* y, const float* z,
                                               const std::vector<float>& intensity,
                                               const Eigen::Vector3d& sensorPosition) const {
  checkReach(sensorPosition);
  const double scale = 65536.0 / voxelSize;
  const Eigen::Vector3d shift =
      (sensorPosition - origin) * scale + Eigen::Vector3d::Constant(65536.0 * kVoxelReach);
  return {{x, shift.x()},
          {y, shift.y()},
          {z, shift.z()},
          scale,
          intensity.empty() ? nullptr : intensity.data(),
          nullptr,
          0};
}

std::size_t VoxelMap::bin(const std::vector<float>& x, const std::vector<float>& y,
                          const std::vector<float>& z, const std::vector<float>& intensity,
                          const Eigen::Vector3d& sensorPosition, IndexSpan indices,
                          std::uint32_t cap, std::vector<VoxelRun>& result) const {
  VoxelReturns returns =
      implementation_->returns(x.data(), y.data(), z.data(), intensity, sensorPosition);
  returns.indices = indices.data;
  returns.count = indices.count;
  BinnedReturns binned;
  binned.permanent.swap(result);
  const std::size_t leftOut = threadsBinning().bin(returns, cap, binned);
  result.swap(binned.permanent);
  return leftOut;
}

std::size_t VoxelMap::binByOwner(const std::vector<float>& x, const std::vector<float>& y,
                                 const std::vector<float>& z, const std::vector<float>& intensity,
                                 const Eigen::Vector3d& sensorPosition,
                                 const std::vector<std::int32_t>& owner, std::uint32_t cap,
                                 BinnedReturns& result) const {
  VoxelReturns returns =
      implementation_->returns(x.data(), y.data(), z.data(), intensity, sensorPosition);
  returns.owner = owner.data();
  returns.count = owner.size();
  return threadsBinning().bin(returns, cap, result);
}

void VoxelMap::add(const RunSpan& runs, const std::vector<bool>* without) {
  implementation_->tiles.add(runs, without);
}

void VoxelMap::subtract(const RunSpan& runs) {
  implementation_->tiles.subtract(runs);
}

void VoxelMap::subtract(const VoxelSum& sum) {
  implementation_->tiles.subtract(sum);
}

ScanPlaces VoxelMap::placesOf(const LevelPoints& level,
                              const Eigen::Vector3d& sensorPosition) const {
  const VoxelReturns scan = implementation_->returns(nullptr, nullptr, nullptr, {}, sensorPosition);
  return {level, scan.scale, {scan.x.shift, scan.y.shift, scan.z.shift}};
}

bool VoxelMap::holds(VoxelKey voxel, int bits) {
  return implementation_->tiles.holds(voxel, bits);
}

std::size_t VoxelMap::size(std::uint32_t minCount) const {
  if (minCount <= 1) return implementation_->tiles.size();
  std::size_t result = 0;
  implementation_->tiles.visit([&](const VoxelSum& sum) { result += sum.count >= minCount; });
  return result;
}

void VoxelMap::leaveBehind(const Eigen::Vector3d& position, double radius) {
  const Eigen::Vector3d place = (position - implementation_->origin) / voxelSize();
  implementation_->tiles.leaveBehind(
      {place.x() + kVoxelReach, place.y() + kVoxelReach, place.z() + kVoxelReach},
      radius / voxelSize());
}

std::size_t VoxelMap::tilesInStore() const {
  return implementation_->tiles.tilesInStore();
}

MapPoint VoxelMap::Implementation::point(const VoxelSum& sum, const Eigen::Vector3d& offset) const {
  const auto index = voxelIndex(sum.key);
  const auto mean = [&sum](std::uint64_t total) {
    return static_cast<double>(total) / 65536.0 / static_cast<double>(sum.count);
  };
  const Eigen::Vector3d place(index[0] + mean(sum.x), index[1] + mean(sum.y),
                              index[2] + mean(sum.z));
  const Eigen::Vector3f p = (origin - offset + voxelSize * place).cast<float>();
  return {p.x(), p.y(), p.z(), static_cast<float>(mean(sum.intensity))};
}

std::vector<MapPoint> VoxelMap::points(std::uint32_t minCount,
                                       const Eigen::Vector3d& offset) const {
  std::vector<MapPoint> result;
  result.reserve(implementation_->tiles.size());
  visitPoints(minCount, offset, [&](const MapPoint& point) { result.push_back(point); });
  return result;
}

void VoxelMap::visitPoints(std::uint32_t minCount, const Eigen::Vector3d& offset,
                           const std::function<void(const MapPoint&)>& visit) const {
  implementation_->tiles.visit([&](const VoxelSum& sum) {
    if (sum.count >= minCount) visit(implementation_->point(sum, offset));
  });
}

double VoxelMap::voxelSize() const {
  return implementation_->voxelSize;
}

std::size_t VoxelMap::bytes() const {
  return implementation_->tiles.bytes();
}

}  // namespace toss
