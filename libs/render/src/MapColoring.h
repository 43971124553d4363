// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/render/RenderOptions.h>

#include <optional>
#include <vector>

#include "Picture.h"

namespace toss {

/// Swatches of the legend, and the colours of what is marked.
constexpr Color kStaticColor{150, 150, 162};
constexpr Color kRemovedColor{255, 45, 45};
constexpr Color kTrueRemovalColor{70, 190, 95};
constexpr Color kLostColor{40, 130, 255};

/// How the points of a map are coloured, and the scale that tells it (none for classes).
struct MapColoring {
  PointColoring colorOf;
  std::optional<LegendScale> scale;
};

/// By height or intensity along a ramp; by class in grey, lighter with height.
MapColoring colorStaticMap(const std::vector<MapPoint>& points, PictureColor color);

}  // namespace toss
