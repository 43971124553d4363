// SPDX-License-Identifier: BSD-3-Clause
#include <toss/mapping/StaticMap.h>

#include "EveryReturnMap.h"
#include "VoxelStaticMap.h"

namespace toss {

namespace {

/// Indices of the returns of each owner, shape [1 + greatest owner], at least that of owner 0.
std::vector<std::vector<std::int32_t>> returnsByOwner(const std::vector<std::int32_t>& owner) {
  std::vector<std::vector<std::int32_t>> returnsOf(1);
  for (std::size_t i = 0; i < owner.size(); ++i) {
    if (owner[i] < 0) continue;
    const auto k = static_cast<std::size_t>(owner[i]);
    if (k >= returnsOf.size()) returnsOf.resize(k + 1);
    returnsOf[k].push_back(static_cast<std::int32_t>(i));
  }
  return returnsOf;
}

}  // namespace

void StaticMap::addScan(const ScanReturns& scan, const std::vector<std::int32_t>& owner,
                        const std::vector<bool>& dynamic, BoxId firstBox) {
  const std::vector<std::vector<std::int32_t>> returnsOf = returnsByOwner(owner);
  addPermanent(scan, returnsOf.front());
  for (std::size_t k = 1; k < returnsOf.size(); ++k)
    if (!returnsOf[k].empty()) addBox(firstBox + k, 0, scan, returnsOf[k], dynamic[k]);
}

void StaticMap::addDecided(std::size_t count, const std::function<DecidedScan(std::size_t)>& scan) {
  for (std::size_t i = 0; i < count; ++i) {
    const DecidedScan each = scan(i);
    for (const std::vector<std::int32_t>& indices : returnsByOwner(each.owner))
      addPermanent(each.returns, indices);
    leaveBehind(each.returns.sensorPosition);
  }
}

std::vector<MapPoint> StaticMap::points(const Eigen::Vector3d& offset) const {
  std::vector<MapPoint> result;
  visitPoints(offset, [&](const MapPoint& point) { result.push_back(point); });
  return result;
}

std::unique_ptr<StaticMap> makeStaticMap(const MappingOptions& options,
                                         const Eigen::Vector3d& origin, TileStore* store) {
  options.check();
  if (options.voxelSize == 0.0) return std::make_unique<EveryReturnMap>(options, origin);
  return std::make_unique<VoxelStaticMap>(options, origin, store);
}

}  // namespace toss
