// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core/mat.hpp>

namespace toss {

/// Depths of a rendered picture as MRPT gives them.
struct DepthImage {
  /// CV_32FC1, 0 where nothing was drawn; made linear as if the camera had perspective.
  cv::Mat values;
  /// Clip distances [m].
  double near = 0.0, far = 0.0;
  /// Of the camera; see Camera.
  bool perspective = true;
  double distance = 1.0;
};

/// Darkens each pixel (CV_8UC3) by how far its neighbours lie in front of it, which draws the
/// outlines that points alone lack (Boucheny, "Interactive scientific visualization of large
/// datasets", 2009: eye-dome lighting). `strength` 1 suits maps; `radius` in pixels.
void shadeByDepth(cv::Mat& picture, const DepthImage& depth, double strength, int radius);

}  // namespace toss
