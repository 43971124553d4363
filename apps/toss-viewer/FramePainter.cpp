// SPDX-License-Identifier: BSD-3-Clause
#include "FramePainter.h"

#include "LineDrawing.h"
#include "LiveColors.h"
#include "LiveScene.h"
#include "Overlay.h"
#include "TextDrawing.h"
#include "TraceShape.h"

namespace toss {
namespace {

constexpr std::size_t kMapLimit = 1000000;

void drawTraces(cv::Mat& picture, const Camera& camera, const LiveFrame& frame) {
  const double unit = picture.rows / 720.0;
  // Movers come first in the frame, and are drawn last.
  for (auto trace = frame.traces.rbegin(); trace != frame.traces.rend(); ++trace) {
    const Color color = colorOf(*trace);
    const double width = trace->sample.moving || trace->flipped ? 2.0 : 1.0;
    for (const Segment& segment : shapeOf(*trace))
      drawPolyline(picture, camera, {segment.first, segment.second}, color, width);
    if (trace->flipped) drawPolyline(picture, camera, trace->path, color, width);
    const std::string caption = captionOf(*trace);
    const auto place = camera.project(captionPlace(*trace));
    if (!caption.empty() && place)
      drawText(picture, caption, place->u, place->v, {10.0 * unit, color, false});
  }
}

Overlay overlayOf(const LiveFrame& frame, const std::string& title) {
  Overlay overlay;
  overlay.title = title;
  overlay.subtitle = statusOf(frame);
  overlay.entries = {{kGroundColor, "ground"},
                     {kStandingColor, "standing"},
                     {kMovingColor, "moving"},
                     {kFlipColor, "verdict changed"}};
  return overlay;
}

}  // namespace

cv::Mat FramePainter::paint(const LiveFrame& frame, const LayerChoice& layers, const Camera& camera,
                            const std::string& title) {
  origin_ = frame.trajectory.front();
  if (frame.map != shownMap_) {
    map_ = mapBatch(*frame.map, origin_, kMapLimit);
    shownMap_ = frame.map;
  }
  PointScene scene;
  scene.origin = origin_;
  scene.batches = scanBatches(frame, layers, origin_);
  for (PointBatch& batch : scene.batches) batch.emphasis = 1.6;
  scene.batches.back().emphasis = 2.2;
  if (layers.has(Layer::Map)) scene.batches.push_back(map_);
  renderer_.setScene(scene);
  cv::Mat picture = renderer_.render(camera, {kBackground, 0.0, 0.6});
  if (layers.has(Layer::Trajectory))
    drawPolyline(picture, camera, frame.trajectory, kTrajectoryColor, 2.0);
  if (layers.has(Layer::Boxes)) drawTraces(picture, camera, frame);
  drawOverlay(picture, overlayOf(frame, title), camera, themeOf(Background::Dark));
  return picture;
}

}  // namespace toss
