// SPDX-License-Identifier: BSD-3-Clause
#include "VoxelStaticMap.h"

#include <tbb/parallel_pipeline.h>

#include <array>

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

std::size_t VoxelStaticMap::binByOwner(const ScanReturns& scan,
                                       const std::vector<std::int32_t>& owner,
                                       BinnedReturns& binned) const {
  return map_.voxels().binByOwner(scan.level.x, scan.level.y, scan.level.z, scan.intensity,
                                  scan.sensorPosition, owner, cap_, binned);
}

void VoxelStaticMap::addScan(const ScanReturns& scan, const std::vector<std::int32_t>& owner,
                             const std::vector<bool>& dynamic, BoxId firstBox) {
  leftOut_ += binByOwner(scan, owner, binned_);
  map_.addScan(binned_, dynamic, firstBox);
}

void VoxelStaticMap::addDecided(std::size_t count,
                                const std::function<DecidedScan(std::size_t)>& scan) {
  struct Binned {
    BinnedReturns runs;
    Eigen::Vector3d sensorPosition;
    std::size_t leftOut = 0;
  };
  constexpr std::size_t kInFlight = 3;
  std::array<Binned, kInFlight> inFlight;
  std::size_t next = 0;
  const auto bin = [&](tbb::flow_control& flow) -> Binned* {
    if (next == count) return flow.stop(), nullptr;
    Binned& binned = inFlight[next % kInFlight];
    const DecidedScan each = scan(next++);
    binned.sensorPosition = each.returns.sensorPosition;
    binned.leftOut = binByOwner(each.returns, each.owner, binned.runs);
    return &binned;
  };
  const auto enter = [&](Binned* binned) {
    map_.addPermanent(binned->runs.permanent);
    map_.addPermanent(binned->runs.owned);
    map_.leaveBehind(binned->sensorPosition);
    leftOut_ += binned->leftOut;
  };
  const auto inOrder = tbb::filter_mode::serial_in_order;
  tbb::parallel_pipeline(kInFlight, tbb::make_filter<void, Binned*>(inOrder, bin) &
                                        tbb::make_filter<Binned*, void>(inOrder, enter));
}

}  // namespace toss
