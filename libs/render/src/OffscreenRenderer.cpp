// SPDX-License-Identifier: BSD-3-Clause
#include "OffscreenRenderer.h"

#include <mrpt/opengl/COpenGLScene.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <exception>
#include <mutex>
#include <opencv2/imgproc.hpp>
#include <thread>

#include "EyeDome.h"
#include "FrameBuffer.h"
#include "PointCloudObject.h"

namespace toss {
namespace {

constexpr double kDegrees = 180.0 / 3.14159265358979323846;

cv::Mat toMat(const mrpt::img::CImage& image) {
  cv::Mat result(static_cast<int>(image.getHeight()), static_cast<int>(image.getWidth()), CV_8UC3);
  for (int row = 0; row < result.rows; ++row)
    std::memcpy(result.ptr(row), image.ptrLine<std::uint8_t>(static_cast<unsigned>(row)),
                static_cast<std::size_t>(result.cols) * 3);
  return result;
}

struct DepthRange {
  double near = 0.0, far = 0.0;
};

DepthRange clipDistances(const Camera& camera, const Extent& extent) {
  DepthRange range{1e30, -1e30};
  for (const Eigen::Vector3d& point : extent.corners()) {
    const double depth = (point - camera.position()).dot(camera.forward());
    range.near = std::min(range.near, depth);
    range.far = std::max(range.far, depth);
  }
  const double margin = 0.01 * camera.distance;
  range.near = std::max(range.near - margin, 0.05 * camera.distance);
  range.far = std::max(range.far, range.near) + margin;
  return range;
}

}  // namespace

struct OffscreenRenderer::Implementation {
  Implementation(int width, int height, int factor)
      : supersampling(factor), frameBuffer(width * factor, height * factor) {}

  void placeCamera(const Camera& camera) {
    auto& view = frameBuffer.renderer().getCamera(*scene);
    const Eigen::Vector3d target = camera.target - origin;
    view.setProjectiveModel(camera.perspective);
    view.setProjectiveFOVdeg(static_cast<float>(Camera::kFieldOfView * kDegrees));
    view.setAzimuthDegrees(static_cast<float>(camera.azimuth * kDegrees));
    view.setElevationDegrees(static_cast<float>(camera.elevation * kDegrees));
    view.setZoomDistance(static_cast<float>(camera.distance));
    view.setPointingAt(mrpt::math::TPoint3D(target.x(), target.y(), target.z()));
  }

  void sizePoints(const Camera& camera, const RenderStyle& style, const DepthRange& range) {
    constexpr double kLeastPixels = 1.6;
    for (std::size_t i = 0; i < clouds.size(); ++i) {
      const double factor = emphases[i] * supersampling;
      auto& cloud = *clouds[i];
      const double pixelsAtOneMetre = sizes[i] * camera.pixelsPerMetre(1.0);
      const bool growing = camera.perspective && style.pointSize == 0.0;
      cloud.enableVariablePointSize(growing);
      if (!growing) {
        const double pixels =
            style.pointSize > 0.0 ? style.pointSize : std::max(kLeastPixels, pixelsAtOneMetre);
        cloud.setPointSize(static_cast<float>(std::max(1.0, factor * pixels)));
        continue;
      }
      // The shader draws pointSize + k / (scale * z + 0.01) pixels, where z is the depth in clip
      // coordinates, a * depth - b. With this scale the constants cancel: k' / depth remains.
      const double a = (range.far + range.near) / (range.far - range.near);
      const double b = 2.0 * range.far * range.near / (range.far - range.near);
      const double scale = 0.01 / b;
      cloud.setPointSize(static_cast<float>(factor * 0.5 * kLeastPixels));
      cloud.setVariablePointSize_k(static_cast<float>(factor * pixelsAtOneMetre * scale * a));
      cloud.setVariablePointSize_DepthScale(static_cast<float>(scale));
    }
  }

  int supersampling;
  FrameBuffer frameBuffer;
  mrpt::opengl::COpenGLScene::Ptr scene;
  std::vector<mrpt::opengl::CPointCloudColoured::Ptr> clouds;
  std::vector<double> sizes, emphases;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Extent extent;
};

OffscreenRenderer::OffscreenRenderer(int width, int height, int supersampling)
    : implementation_(std::make_unique<Implementation>(width, height, supersampling)) {}

OffscreenRenderer::~OffscreenRenderer() = default;

void OffscreenRenderer::setScene(const PointScene& scene) {
  Implementation& self = *implementation_;
  self.scene = mrpt::opengl::COpenGLScene::Create();
  self.clouds.clear();
  self.sizes.clear();
  self.emphases.clear();
  self.origin = scene.origin;
  self.extent = {scene.origin, scene.origin};
  for (const PointBatch& batch : scene.batches) {
    if (batch.positions.empty()) continue;
    for (const Eigen::Vector3f& position : batch.positions)
      self.extent.include(scene.origin + position.cast<double>());
    self.clouds.push_back(toPointCloudObject(batch));
    self.sizes.push_back(batch.size);
    self.emphases.push_back(batch.emphasis);
    self.scene->insert(self.clouds.back());
  }
}

cv::Mat OffscreenRenderer::render(const Camera& camera, const RenderStyle& style) {
  Implementation& self = *implementation_;
  const DepthRange range = clipDistances(camera, self.extent);
  const auto viewport = self.scene->getViewport();
  viewport->setViewportClipDistances(static_cast<float>(range.near), static_cast<float>(range.far));
  viewport->setCustomBackgroundColor(mrpt::img::TColorf(
      mrpt::img::TColor(style.background.red, style.background.green, style.background.blue)));
  self.placeCamera(camera);
  self.sizePoints(camera, style, range);
  mrpt::img::CImage image;
  mrpt::math::CMatrixFloat depth;
  self.frameBuffer.renderer().render_RGBD(*self.scene, image, depth);
  cv::Mat picture = toMat(image);
  if (style.shading > 0.0) {
    cv::Mat depths(picture.rows, picture.cols, CV_32FC1, depth.data());
    const DepthImage measured{depths, range.near, range.far, camera.perspective, camera.distance};
    shadeByDepth(picture, measured, style.shading, self.supersampling);
  }
  if (self.supersampling == 1) return picture;
  cv::Mat smooth;
  cv::resize(picture, smooth, {camera.width, camera.height}, 0, 0, cv::INTER_AREA);
  return smooth;
}

void inRenderThread(const std::function<void()>& work) {
  static std::mutex oneAtATime;
  const std::lock_guard<std::mutex> lock(oneAtATime);
  std::exception_ptr failure;
  std::thread thread([&] {
    try {
      work();
    } catch (...) {
      failure = std::current_exception();
    }
  });
  thread.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace toss
