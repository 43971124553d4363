// SPDX-License-Identifier: BSD-3-Clause
#include "Picture.h"

#include <toss/render/PointSample.h>

#include <algorithm>
#include <cmath>

#include "LineDrawing.h"
#include "PictureFile.h"
#include "PointSpacing.h"

namespace toss {
namespace {

// Points as large as this times their spacing close the gaps in surfaces seen at an angle.
constexpr double kOverlap = 1.4;

RenderOptions checked(RenderOptions options) {
  options.check();
  options.width -= options.width % 4;
  // Larger frame buffers would take gigabytes, and such pictures are fine as they are.
  if (std::max(options.width, options.height) > 4096) options.supersampling = 1;
  return options;
}

}  // namespace

PointBatch makeBatch(const std::vector<MapPoint>& points, const Eigen::Vector3d& origin,
                     std::size_t limit, double size, const PointColoring& coloring) {
  PointBatch batch;
  const std::vector<std::uint32_t> indices = sampleIndices(points.size(), limit);
  batch.positions.reserve(indices.size());
  batch.colors.reserve(indices.size());
  for (const std::uint32_t index : indices) {
    const MapPoint& point = points[index];
    const Eigen::Vector3d relative = Eigen::Vector3d(point.x, point.y, point.z) - origin;
    if (!relative.allFinite()) continue;
    batch.positions.push_back(relative.cast<float>());
    batch.colors.push_back(coloring(point));
  }
  batch.size = size > 0.0 ? size : kOverlap * pointSpacing(batch.positions);
  return batch;
}

ViewSubject subjectOf(const std::vector<MapPoint>& points,
                      const std::vector<Eigen::Vector3d>& trajectory) {
  ViewSubject subject;
  subject.extent = robustExtent(points);
  subject.outline = outlineOf(points, subject.extent);
  for (const Eigen::Vector3d& position : trajectory) {
    subject.extent.include(position);
    subject.outline.push_back(position);
  }
  const Eigen::Vector3d size = subject.extent.size();
  subject.focus = subject.extent.center();
  subject.heading = size.x() >= size.y() ? 0.0 : std::atan2(1.0, 0.0);
  if (trajectory.empty()) return subject;
  const std::size_t last = trajectory.size() - 1;
  subject.focus = trajectory[last / 2];
  const Eigen::Vector3d step = trajectory[last - last / 3] - trajectory[last / 3];
  if (step.head<2>().norm() > 0.5) subject.heading = std::atan2(step.y(), step.x());
  return subject;
}

PictureDrawer::PictureDrawer(const RenderOptions& options)
    : options_(checked(options)),
      renderer_(options_.width, options_.height, options_.supersampling) {}

void PictureDrawer::draw(const Picture& picture, const std::vector<ViewFile>& views) {
  const Theme theme = themeOf(options_.background);
  renderer_.setScene(picture.scene);
  for (const ViewFile& target : views) {
    const Camera camera = frameView(target.view, picture.subject, options_.width, options_.height,
                                    mapFrame(options_.width, options_.height));
    cv::Mat canvas =
        renderer_.render(camera, {theme.background, options_.pointSize, options_.shading});
    if (picture.trajectory) {
      drawPolyline(canvas, camera, *picture.trajectory, theme.background, 5.0);
      drawPolyline(canvas, camera, *picture.trajectory, theme.text, 2.5);
    }
    if (picture.tracks)
      for (const TrackPath& path : *picture.tracks) drawTrack(canvas, camera, path);
    drawOverlay(canvas, picture.overlay, camera, theme);
    writePicture(target.file, canvas);
  }
}

std::string countText(std::size_t count) {
  std::string text = std::to_string(count);
  for (std::size_t place = text.size(); place > 3;) text.insert(place -= 3, " ");
  return text;
}

std::string countText(std::size_t count, const std::string& noun) {
  return countText(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string sizeText(const Extent& extent) {
  const Eigen::Vector3d size = extent.size();
  return std::to_string(std::lround(size.x())) + " x " + std::to_string(std::lround(size.y())) +
         " m";
}

}  // namespace toss
