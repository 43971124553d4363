// SPDX-License-Identifier: BSD-3-Clause
#include <toss/segmentation/LinkRules.h>

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
      rows(image.rows),
      columns(image.columns),
      rowWindow(options.rowWindow),
      maxHeightGap(static_cast<float>(options.maxHeightGap)),
      options_(options),
      horizontal_(distance(options.horizontalDistance, options.horizontalSteps, columnStep)),
      vertical_(distance(options.verticalDistance, options.verticalSteps, rowStep)) {}

LinkRules::Distance LinkRules::distance(double base, double steps, float step) const {
  if (options_.metric == LinkMetric::Constant) {
    return {0.0f, static_cast<float>(base), static_cast<float>(base)};
  }
  return {static_cast<float>(steps) * step, static_cast<float>(options_.nearFactor * base),
          static_cast<float>(options_.farFactor * base)};
}

int LinkRules::minPoints(float range) const {
  const double columnsHit = options_.minSize / (std::max(range, 0.1f) * columnStep);
  const double rowsHit = options_.minSize / (std::max(range, 0.1f) * rowStep);
  const int expected = static_cast<int>(std::min(1e6, columnsHit * rowsHit));
  return std::max(options_.minPointsFar, std::min(expected, options_.minPointsNear));
}

}  // namespace toss
