// SPDX-License-Identifier: BSD-3-Clause
#include "VoxelStaticMap.h"

namespace toss {

VoxelStaticMap::VoxelStaticMap(const MappingOptions& options, const Eigen::Vector3d& origin,
                               TileStore* store)
    : map_(options, origin, store),
      cap_(static_cast<std::uint32_t>(options.cap)),
      minPoints_(static_cast<std::uint32_t>(options.minPoints)) {}

const std::vector<VoxelRun>& VoxelStaticMap::bin(const ScanReturns& scan, IndexSpan indices) {
  leftOut_ += map_.voxels().bin(scan.level.x, scan.level.y, scan.level.z, scan.intensity,
                                scan.sensorPosition, indices, cap_, runs_);
  return runs_;
}

void VoxelStaticMap::addPermanent(const ScanReturns& scan, IndexSpan indices) {
  map_.addPermanent(bin(scan, indices));
}

void VoxelStaticMap::addBox(BoxId box, TrackId track, const ScanReturns& scan, IndexSpan indices,
                            bool dynamic) {
  map_.addBox(box, track, bin(scan, indices), dynamic);
}

void VoxelStaticMap::addToTrack(TrackId track, const ScanReturns& scan, IndexSpan indices) {
  map_.addToTrack(track, bin(scan, indices));
}

void VoxelStaticMap::binByOwner(const ScanReturns& scan, const std::vector<std::int32_t>& owner) {
  leftOut_ += map_.voxels().binByOwner(scan.level.x, scan.level.y, scan.level.z, scan.intensity,
                                       scan.sensorPosition, owner, cap_, binned_);
}

void VoxelStaticMap::addScan(const ScanReturns& scan, const std::vector<std::int32_t>& owner,
                             const std::vector<bool>& dynamic, BoxId firstBox) {
  binByOwner(scan, owner);
  map_.addScan(binned_, dynamic, firstBox);
}

void VoxelStaticMap::addDecided(const ScanReturns& scan, const std::vector<std::int32_t>& owner) {
  binByOwner(scan, owner);
  map_.addPermanent(binned_.permanent);
  map_.addPermanent(binned_.owned);
}

}  // namespace toss
