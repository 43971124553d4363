// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/opengl/CPointCloudColoured.h>

#include "OffscreenRenderer.h"

namespace toss {

/// The batch as MRPT draws and stores it, coordinates relative to PointScene::origin.
mrpt::opengl::CPointCloudColoured::Ptr toPointCloudObject(const PointBatch& batch);

}  // namespace toss
