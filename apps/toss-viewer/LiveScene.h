// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "LiveFrame.h"
#include "OffscreenRenderer.h"

namespace toss {

/// The layers of a frame as coloured points, in the order of Layer::Ground, Standing, Moving; with
/// coordinates relative to `origin` [m].
std::vector<PointBatch> scanBatches(const LiveFrame& frame, const LayerChoice& layers,
                                    const Eigen::Vector3d& origin);
/// The map in grey, lighter with height; at most `limit` points.
PointBatch mapBatch(const std::vector<MapPoint>& map, const Eigen::Vector3d& origin,
                    std::size_t limit);

}  // namespace toss
