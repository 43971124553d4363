// SPDX-License-Identifier: BSD-3-Clause
#include <toss/evaluation/MapEstimates.h>
#include <toss/evaluation/VoxelGrid.h>

#include <stdexcept>

namespace toss {

MapEstimates::MapEstimates(double voxelSize, int count)
    : voxelSize_(voxelSize), scan_(static_cast<std::size_t>(count)) {
  if (count < 1 || count > kMost) throw std::logic_error("MapEstimates: count out of range");
}

void MapEstimates::addScan(const CellOrder& order, const std::vector<std::uint32_t>& label,
                           const std::vector<std::uint16_t>& membership) {
  ordered_ = false;
  voxelizeScan(order, label, membership);
  join();
}

void MapEstimates::voxelizeScan(const CellOrder& order, const std::vector<std::uint32_t>& label,
                                const std::vector<std::uint16_t>& membership) {
  std::size_t truthPlaces = 0;
  for (std::size_t e = 0; e < scan_.size(); ++e) {
    ScanVoxels& voxels = scan_[e];
    voxels.cursor = 0;
    selectMembers(order, membership, bit(static_cast<int>(e)), selected_);
    if (e > 0 && selected_.places() == truthPlaces) {
      voxels.cloud = scan_[0].cloud, voxels.key = scan_[0].key;
      continue;
    }
    if (e == 0) truthPlaces = selected_.places();
    voxelize(selected_, label, voxelSize_, voxels.cloud, &voxels.key);
  }
}

void MapEstimates::join() {
  const std::vector<CellKey>& cells = scan_[0].key;
  for (const CellKey cell : cells) {
    const std::size_t cellBegin = joined_.size();
    for (std::size_t e = 0; e < scan_.size(); ++e) {
      ScanVoxels& voxels = scan_[e];
      if (voxels.cursor >= voxels.key.size() || voxels.key[voxels.cursor] != cell) continue;
      addVoxel(voxels.cloud, voxels.cursor++, bit(static_cast<int>(e)), cellBegin);
    }
  }
  for (const ScanVoxels& voxels : scan_) {
    if (voxels.cursor != voxels.key.size()) {
      throw std::logic_error(
          "MapEstimates: an estimate keeps a point that the truth does not have");
    }
  }
}

void MapEstimates::addVoxel(const LabelledCloud& cloud, std::size_t i, std::uint16_t mapBit,
                            std::size_t cellBegin) {
  for (std::size_t j = cellBegin; j < joined_.size(); ++j) {
    if (joined_.x[j] == cloud.x[i] && joined_.y[j] == cloud.y[i] && joined_.z[j] == cloud.z[i] &&
        joined_.label[j] == cloud.label[i]) {
      membership_[j] = static_cast<std::uint16_t>(membership_[j] | mapBit);
      return;
    }
  }
  joined_.add(cloud.x[i], cloud.y[i], cloud.z[i], cloud.label[i]);
  membership_.push_back(mapBit);
}

LabelledCloud MapEstimates::voxelized(int number) {
  if (!ordered_) orderByCell(joined_, voxelSize_, joinedOrder_);
  ordered_ = true;
  selectMembers(joinedOrder_, membership_, bit(number), selected_);
  LabelledCloud result;
  voxelize(selected_, joined_.label, voxelSize_, result);
  return result;
}

}  // namespace toss
