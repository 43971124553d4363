// SPDX-License-Identifier: BSD-3-Clause
#include <toss/segmentation/LinkRules.h>

#include <algorithm>
#include <cmath>

namespace toss {
namespace {

/// Row step of an image of a single row, where it plays no part.
constexpr float kSingleRowStep = 0.0073f;

float meanRowStep(const RangeImage& image) {
  if (image.elevations.size() < 2) return kSingleRowStep;
  const float span = image.elevations.front() - image.elevations.back();
  return std::max(1e-4f, span / static_cast<float>(image.elevations.size() - 1));
}

}  // namespace

LinkRules::LinkRules(const ObjectOptions& options, const RangeImage& image)
    : columnStep(2.0f * static_cast<float>(M_PI) / static_cast<float>(std::max(1, image.columns))),
      rowStep(meanRowStep(image)),
      columns(image.columns),
      rowWindow(options.rowWindow),
      maxHeightGap(static_cast<float>(options.maxHeightGap)),
      options_(options) {}

float LinkRules::linkDistance(float range, double base, double steps, float step) const {
  if (options_.metric == LinkMetric::Constant) return static_cast<float>(base);
  const float angle = static_cast<float>(steps) * step;
  return std::clamp(range * angle, static_cast<float>(options_.nearFactor * base),
                    static_cast<float>(options_.farFactor * base));
}

LinkRules::Reach LinkRules::reach(float range) const {
  Reach reach;
  reach.horizontal =
      linkDistance(range, options_.horizontalDistance, options_.horizontalSteps, columnStep);
  reach.vertical = linkDistance(range, options_.verticalDistance, options_.verticalSteps, rowStep);
  // A distance d spans at most asin(d / range), which 1.2 d / range exceeds up to 50 degrees. One
  // more column because the returns lie anywhere in theirs.
  const float columnsSpanned =
      1.2f * std::max(reach.horizontal, reach.vertical) / (std::max(range, 0.01f) * columnStep);
  const float most = static_cast<float>(columns / 2);
  reach.window = static_cast<int>(std::min(most, std::ceil(columnsSpanned) + 1.0f));
  return reach;
}

int LinkRules::minPoints(float range) const {
  const double columnsHit = options_.minSize / (std::max(range, 0.1f) * columnStep);
  const double rowsHit = options_.minSize / (std::max(range, 0.1f) * rowStep);
  const int expected = static_cast<int>(std::min(1e6, columnsHit * rowsHit));
  return std::max(options_.minPointsFar, std::min(expected, options_.minPointsNear));
}

}  // namespace toss
