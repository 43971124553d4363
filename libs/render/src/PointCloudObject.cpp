// SPDX-License-Identifier: BSD-3-Clause
#include "PointCloudObject.h"

#include "BulkPointCloud.h"

namespace toss {

mrpt::opengl::CPointCloudColoured::Ptr toPointCloudObject(const PointBatch& batch) {
  auto cloud = std::make_shared<BulkPointCloud>();
  cloud->assign(batch);
  return cloud;
}

}  // namespace toss
