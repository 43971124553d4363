// SPDX-License-Identifier: BSD-3-Clause
#include <toss/geometry/Error.h>
#include <toss/mapping/VoxelMap.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "VoxelBinning.h"
#include "VoxelTable.h"

namespace toss {

struct VoxelMap::Implementation {
  double voxelSize;
  Eigen::Vector3d origin;
  VoxelTable table;

  MapPoint point(const VoxelSum& sum) const;
  void checkReach(const Eigen::Vector3d& sensorPosition) const;
};

VoxelMap::VoxelMap(double voxelSize, const Eigen::Vector3d& origin)
    : implementation_(new Implementation{voxelSize, origin, {}}) {
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

std::size_t VoxelMap::bin(const std::vector<float>& x, const std::vector<float>& y,
                          const std::vector<float>& z, const std::vector<float>& intensity,
                          const Eigen::Vector3d& sensorPosition, IndexSpan indices,
                          std::uint32_t cap, std::vector<VoxelContribution>& result) const {
  implementation_->checkReach(sensorPosition);
  thread_local VoxelBinning binning;
  const double scale = 65536.0 / implementation_->voxelSize;
  const Eigen::Vector3d shift = (sensorPosition - implementation_->origin) * scale +
                                Eigen::Vector3d::Constant(65536.0 * kVoxelReach);
  const std::size_t leftOut = binning.take({x.data(), shift.x()}, {y.data(), shift.y()},
                                           {z.data(), shift.z()}, scale, intensity, indices);
  binning.sum(cap, result);
  return leftOut;
}

void VoxelMap::add(const std::vector<VoxelContribution>& contributions) {
  implementation_->table.add(contributions);
}

void VoxelMap::subtract(const std::vector<VoxelContribution>& contributions) {
  for (const VoxelContribution& c : contributions) {
    implementation_->table.subtract({c.key, c.count, c.x, c.y, c.z, c.intensity});
  }
}

void VoxelMap::subtract(const std::vector<VoxelSum>& sums) {
  for (const VoxelSum& sum : sums) implementation_->table.subtract(sum);
}

std::size_t VoxelMap::size(std::uint32_t minCount) const {
  if (minCount <= 1) return implementation_->table.size();
  std::size_t result = 0;
  implementation_->table.visit([&](const VoxelSum& sum) { result += sum.count >= minCount; });
  return result;
}

MapPoint VoxelMap::Implementation::point(const VoxelSum& sum) const {
  const auto index = voxelIndex(sum.key);
  const auto mean = [&sum](std::uint64_t total) {
    return static_cast<double>(total) / 65536.0 / static_cast<double>(sum.count);
  };
  const Eigen::Vector3d place(index[0] + mean(sum.x), index[1] + mean(sum.y),
                              index[2] + mean(sum.z));
  const Eigen::Vector3f p = (origin + voxelSize * place).cast<float>();
  return {p.x(), p.y(), p.z(), static_cast<float>(mean(sum.intensity))};
}

std::vector<MapPoint> VoxelMap::points(std::uint32_t minCount) const {
  std::vector<MapPoint> result;
  result.reserve(size(minCount));
  implementation_->table.visit([&](const VoxelSum& sum) {
    if (sum.count >= minCount) result.push_back(implementation_->point(sum));
  });
  return result;
}

double VoxelMap::voxelSize() const {
  return implementation_->voxelSize;
}

std::size_t VoxelMap::bytes() const {
  return implementation_->table.bytes();
}

}  // namespace toss
