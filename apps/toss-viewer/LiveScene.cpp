// SPDX-License-Identifier: BSD-3-Clause
#include "LiveScene.h"

#include "LiveColors.h"
#include "MapColoring.h"
#include "Picture.h"

namespace toss {

std::vector<PointBatch> scanBatches(const LiveFrame& frame, const LayerChoice& layers,
                                    const Eigen::Vector3d& origin) {
  std::vector<PointBatch> batches;
  const auto add = [&](Layer layer, const std::vector<MapPoint>& points, const Color& color) {
    const std::vector<MapPoint> none;
    const auto& shown = layers.has(layer) ? points : none;
    batches.push_back(
        makeBatch(shown, origin, shown.size(), 0.1, [&](const MapPoint&) { return color; }));
  };
  add(Layer::Ground, frame.ground, kGroundColor);
  add(Layer::Standing, frame.standing, kStandingColor);
  add(Layer::Moving, frame.moving, kMovingColor);
  return batches;
}

PointBatch mapBatch(const std::vector<MapPoint>& map, const Eigen::Vector3d& origin,
                    std::size_t limit) {
  const MapColoring coloring = colorStaticMap(map, PictureColor::Class);
  const auto darker = [&](const MapPoint& point) {
    const Color c = coloring.colorOf(point);
    const auto dim = [](std::uint8_t value) { return static_cast<std::uint8_t>(value * 6 / 10); };
    return Color{dim(c.red), dim(c.green), dim(c.blue)};
  };
  return makeBatch(map, origin, limit, 0.1, darker);
}

}  // namespace toss
