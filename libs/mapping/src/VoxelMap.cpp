// SPDX-License-Identifier: BSD-3-Clause
#include <toss/geometry/Error.h>
#include <toss/mapping/VoxelMap.h>

#include <algorithm>
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

  template <typename Sum>
  void subtract(const Sum& sum);
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
  for (const VoxelContribution& c : contributions) {
    VoxelRecord& record = implementation_->table.findOrMake(c.key);
    const VoxelSum s = record.sum();
    record.set(
        {c.key, s.count + c.count, s.x + c.x, s.y + c.y, s.z + c.z, s.intensity + c.intensity});
  }
}

template <typename Sum>
void VoxelMap::Implementation::subtract(const Sum& c) {
  VoxelRecord* const record = table.find(c.key);
  const VoxelSum s = record ? record->sum() : VoxelSum();
  if (s.count < c.count || s.x < c.x || s.y < c.y || s.z < c.z || s.intensity < c.intensity) {
    throw std::logic_error("VoxelMap: subtracts what was never added");
  }
  if (!record) return;
  record->set(
      {c.key, s.count - c.count, s.x - c.x, s.y - c.y, s.z - c.z, s.intensity - c.intensity});
  if (record->count == 0) table.erase(c.key);
}

void VoxelMap::subtract(const std::vector<VoxelContribution>& contributions) {
  for (const VoxelContribution& c : contributions) implementation_->subtract(c);
}

void VoxelMap::subtract(const std::vector<VoxelSum>& sums) {
  for (const VoxelSum& sum : sums) implementation_->subtract(sum);
}

std::size_t VoxelMap::size(std::uint32_t minCount) const {
  if (minCount <= 1) return implementation_->table.size();
  std::size_t result = 0;
  implementation_->table.visit(
      [&](const VoxelRecord& record) { result += record.count >= minCount; });
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
  std::vector<const VoxelRecord*> order;
  order.reserve(implementation_->table.size());
  implementation_->table.visit([&](const VoxelRecord& record) {
    if (record.count >= minCount) order.push_back(&record);
  });
  std::sort(order.begin(), order.end(),
            [](const VoxelRecord* a, const VoxelRecord* b) { return a->key < b->key; });
  std::vector<MapPoint> result;
  result.reserve(order.size());
  for (const VoxelRecord* record : order) result.push_back(implementation_->point(record->sum()));
  return result;
}

double VoxelMap::voxelSize() const {
  return implementation_->voxelSize;
}

std::size_t VoxelMap::bytes() const {
  return implementation_->table.bytes();
}

}  // namespace toss
