// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/render/Camera.h>

#include <opencv2/core/mat.hpp>
#include <string>

#include "LiveFrame.h"
#include "OffscreenRenderer.h"

namespace toss {

/// Draws frames without a display. Lives inside inRenderThread().
class FramePainter {
 public:
  /// Size of the pictures [px], width a multiple of 4. Throws RenderUnavailable.
  FramePainter(int width, int height) : renderer_(width, height, 1) {}

  /// BGR picture of the frame under `title`; `camera` has the painter's size.
  cv::Mat paint(const LiveFrame& frame, const LayerChoice& layers, const Camera& camera,
                const std::string& title);

 private:
  OffscreenRenderer renderer_;
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
  PointBatch map_;
  std::shared_ptr<const std::vector<MapPoint>> shownMap_;
};

}  // namespace toss
