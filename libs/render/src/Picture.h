// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/render/Camera.h>
#include <toss/render/MapContent.h>
#include <toss/render/RenderOptions.h>

#include <filesystem>
#include <functional>
#include <vector>

#include "OffscreenRenderer.h"
#include "Overlay.h"

namespace toss {

using PointColoring = std::function<Color(const MapPoint&)>;

/// A picture before a view is chosen.
struct Picture {
  PointScene scene;
  Overlay overlay;
  ViewSubject subject;
  /// Drawn over the points; null = none.
  const std::vector<Eigen::Vector3d>* trajectory = nullptr;
  const std::vector<TrackPath>* tracks = nullptr;
};

/// A batch of at most `limit` of the points; `size`: see PointBatch, 0 = from the points
/// themselves.
PointBatch makeBatch(const std::vector<MapPoint>& points, const Eigen::Vector3d& origin,
                     std::size_t limit, double size, const PointColoring& coloring);

/// The map with its trajectory: focus and heading are those of the trajectory's middle; without
/// one, the middle of the map and its longer side.
ViewSubject subjectOf(const std::vector<MapPoint>& points,
                      const std::vector<Eigen::Vector3d>& trajectory);

/// A view of a picture and the file it goes to.
struct ViewFile {
  View view = View::Top;
  std::filesystem::path file;
};

/// Makes pictures of one size one after the other. Lives inside inRenderThread().
class PictureDrawer {
 public:
  /// Throws UserError for options out of range, RenderUnavailable.
  explicit PictureDrawer(const RenderOptions& options);
  void draw(const Picture& picture, const std::vector<ViewFile>& views);

 private:
  RenderOptions options_;
  OffscreenRenderer renderer_;
};

/// Number with its thousands set apart, e.g. "1 234 567".
std::string countText(std::size_t count);
/// "1 point", "2 points".
std::string countText(std::size_t count, const std::string& noun);
/// "182 x 96 m".
std::string sizeText(const Extent& extent);

}  // namespace toss
