// SPDX-License-Identifier: BSD-3-Clause
#include "PointCloudObject.h"

namespace toss {

mrpt::opengl::CPointCloudColoured::Ptr toPointCloudObject(const PointBatch& batch) {
  auto cloud = mrpt::opengl::CPointCloudColoured::Create();
  cloud->reserve(batch.positions.size());
  for (std::size_t i = 0; i < batch.positions.size(); ++i) {
    const Eigen::Vector3f& p = batch.positions[i];
    const Color& color = batch.colors[i];
    cloud->insertPoint({p.x(), p.y(), p.z(), color.red, color.green, color.blue, 255});
  }
  return cloud;
}

}  // namespace toss
