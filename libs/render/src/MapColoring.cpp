// SPDX-License-Identifier: BSD-3-Clause
#include "MapColoring.h"

namespace toss {

MapColoring colorStaticMap(const std::vector<MapPoint>& points, PictureColor color) {
  if (color == PictureColor::Intensity) {
    const ValueRange range = intensityRange(points);
    return {[range](const MapPoint& p) {
              return rampColor(Ramp::Viridis, range.position(p.intensity));
            },
            LegendScale{Ramp::Viridis, range, "intensity"}};
  }
  const ValueRange range = heightRange(points);
  const Ramp ramp = color == PictureColor::Height ? Ramp::Turbo : Ramp::Gray;
  MapColoring coloring{
      [range, ramp](const MapPoint& p) { return rampColor(ramp, range.position(p.z)); }, {}};
  if (color == PictureColor::Height) coloring.scale = LegendScale{ramp, range, "height [m]"};
  return coloring;
}

}  // namespace toss
