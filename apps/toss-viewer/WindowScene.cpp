// SPDX-License-Identifier: BSD-3-Clause
#include "WindowScene.h"

#include <mrpt/opengl/CText.h>

#include "LiveColors.h"
#include "LiveScene.h"
#include "PointCloudObject.h"
#include "TraceShape.h"

namespace toss {
namespace {

constexpr std::size_t kMapLimit = 1000000;

mrpt::img::TColor toMrpt(const Color& color) {
  return {color.red, color.green, color.blue};
}

mrpt::opengl::CPointCloudColoured::Ptr cloudOf(const PointBatch& batch, double pointSize) {
  auto cloud = toPointCloudObject(batch);
  cloud->enableVariablePointSize(false);
  cloud->setPointSize(static_cast<float>(std::max(1.0, pointSize)));
  return cloud;
}

void appendLine(mrpt::opengl::CSetOfLines& lines, const Eigen::Vector3d& from,
                const Eigen::Vector3d& to) {
  lines.appendLine(from.x(), from.y(), from.z(), to.x(), to.y(), to.z());
}

mrpt::opengl::CSetOfLines::Ptr linesOf(const LiveTrace& trace, const Eigen::Vector3d& origin) {
  auto lines = mrpt::opengl::CSetOfLines::Create();
  lines->setColor_u8(toMrpt(colorOf(trace)));
  for (const auto& [from, to] : shapeOf(trace)) appendLine(*lines, from - origin, to - origin);
  if (trace.flipped)
    for (std::size_t i = 1; i < trace.path.size(); ++i)
      appendLine(*lines, trace.path[i - 1] - origin, trace.path[i] - origin);
  return lines;
}

mrpt::opengl::CText::Ptr captionObject(const LiveTrace& trace, const Eigen::Vector3d& origin) {
  auto text = mrpt::opengl::CText::Create(captionOf(trace));
  text->setColor_u8(toMrpt(colorOf(trace)));
  const Eigen::Vector3d place = captionPlace(trace) - origin;
  text->setLocation(place.x(), place.y(), place.z());
  return text;
}

}  // namespace

WindowScene::WindowScene(const mrpt::opengl::COpenGLScene::Ptr& scene)
    : scene_(scene),
      points_(mrpt::opengl::CSetOfObjects::Create()),
      map_(mrpt::opengl::CSetOfObjects::Create()),
      traces_(mrpt::opengl::CSetOfObjects::Create()),
      trajectory_(mrpt::opengl::CSetOfLines::Create()) {
  trajectory_->setColor_u8(toMrpt(kTrajectoryColor));
  scene_->clear();
  scene_->insert(map_);
  scene_->insert(points_);
  scene_->insert(trajectory_);
  scene_->insert(traces_);
  const auto viewport = scene_->getViewport();
  viewport->setCustomBackgroundColor(mrpt::img::TColorf(toMrpt(kBackground)));
  viewport->setViewportClipDistances(0.5f, 2000.0f);
}

void WindowScene::show(const LiveFrame& frame, const LayerChoice& layers) {
  if (!placed_) origin_ = frame.mapFromSensor.translation();
  placed_ = true;
  showMap(frame, layers);
  showPoints(frame, layers);
  showTraces(frame, layers);
  showTrajectory(frame, layers);
}

void WindowScene::showPoints(const LiveFrame& frame, const LayerChoice& layers) {
  points_->clear();
  for (const PointBatch& batch : scanBatches(frame, layers, origin_))
    points_->insert(cloudOf(batch, layers.pointSize));
}

void WindowScene::showMap(const LiveFrame& frame, const LayerChoice& layers) {
  map_->setVisibility(layers.has(Layer::Map));
  if (frame.map != shownMap_) {
    map_->clear();
    map_->insert(cloudOf(mapBatch(*frame.map, origin_, kMapLimit), layers.pointSize - 1.0));
    shownMap_ = frame.map;
  }
  for (const auto& object : *map_)
    if (const auto cloud = std::dynamic_pointer_cast<mrpt::opengl::CPointCloudColoured>(object))
      cloud->setPointSize(static_cast<float>(std::max(1.0, layers.pointSize - 1.0)));
}

void WindowScene::showTraces(const LiveFrame& frame, const LayerChoice& layers) {
  traces_->clear();
  if (!layers.has(Layer::Boxes)) return;
  for (const LiveTrace& trace : frame.traces) {
    traces_->insert(linesOf(trace, origin_));
    if (!captionOf(trace).empty()) traces_->insert(captionObject(trace, origin_));
  }
}

void WindowScene::showTrajectory(const LiveFrame& frame, const LayerChoice& layers) {
  trajectory_->setVisibility(layers.has(Layer::Trajectory));
  trajectory_->clear();
  for (std::size_t i = 1; i < frame.trajectory.size(); ++i)
    appendLine(*trajectory_, frame.trajectory[i - 1] - origin_, frame.trajectory[i] - origin_);
}

}  // namespace toss
