// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/render/Camera.h>
#include <toss/render/Color.h>

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <vector>

namespace toss {

/// Coloured points to draw, coordinates [m] relative to PointScene::origin.
struct PointBatch {
  std::vector<Eigen::Vector3f> positions;
  std::vector<Color> colors;
  /// Edge of a point [m]: what is between neighbouring points.
  double size = 0.1;
  /// Factor on the size, to make a batch stand out.
  double emphasis = 1.0;
};

/// What is drawn by the graphics library. Lines and text are laid over afterwards: MRPT 2.5.8 draws
/// all lines one pixel wide.
struct PointScene {
  /// Map coordinates [m] of the batches' origin: near the points, so that floats stay exact.
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  std::vector<PointBatch> batches;
};

/// Look of a rendered picture.
struct RenderStyle {
  Color background;
  /// See RenderOptions.
  double pointSize = 0.0, shading = 1.0;
};

/// Draws points off-screen through EGL. To be made, used and destroyed inside one call of
/// inRenderThread(): the frame buffer belongs to its thread, and a thread can have but one.
class OffscreenRenderer {
 public:
  /// Size of the finished picture [px], width a multiple of 4. Throws RenderUnavailable.
  OffscreenRenderer(int width, int height, int supersampling);
  ~OffscreenRenderer();

  /// Replaces what is drawn.
  void setScene(const PointScene& scene);
  /// BGR picture of width x height; `camera` has that size.
  cv::Mat render(const Camera& camera, const RenderStyle& style);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// Runs `work` in a thread of its own and waits for it; one at a time in the whole program. Passes
/// on what it throws.
void inRenderThread(const std::function<void()>& work);

}  // namespace toss
