// SPDX-License-Identifier: BSD-3-Clause
#include <toss/mapping/StaticMap.h>

#include "EveryReturnMap.h"
#include "VoxelStaticMap.h"

namespace toss {

std::unique_ptr<StaticMap> makeStaticMap(const MappingOptions& options,
                                         const Eigen::Vector3d& origin) {
  options.check();
  if (options.voxelSize == 0.0) return std::make_unique<EveryReturnMap>(options);
  return std::make_unique<VoxelStaticMap>(options, origin);
}

}  // namespace toss
