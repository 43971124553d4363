// SPDX-License-Identifier: BSD-3-Clause
#include <toss/mapping/StaticMap.h>

#include "EveryReturnMap.h"
#include "VoxelStaticMap.h"

namespace toss {

void StaticMap::addScan(const ScanReturns& scan, const std::vector<std::int32_t>& owner,
                        const std::vector<bool>& dynamic, BoxId firstBox) {
  std::vector<std::vector<std::int32_t>> returnsOf(dynamic.size());
  for (std::size_t i = 0; i < owner.size(); ++i)
    if (owner[i] >= 0)
      returnsOf[static_cast<std::size_t>(owner[i])].push_back(static_cast<std::int32_t>(i));
  addPermanent(scan, returnsOf.front());
  for (std::size_t k = 1; k < returnsOf.size(); ++k)
    if (!returnsOf[k].empty()) addBox(firstBox + k, 0, scan, returnsOf[k], dynamic[k]);
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
