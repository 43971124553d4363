// SPDX-License-Identifier: BSD-3-Clause
#include <toss/segmentation/LinkRules.h>

#include <cmath>

namespace toss {
namespace {

/// Row step of an image of a single row, where it plays no part.
constexpr float kSingleRowStep = 0.0073f;
/// Columns and rows that the link angles span at least, so that neighbours can be linked at all.
constexpr float kColumnsSpanned = 2.5f, kRowsSpanned = 1.0f;

float meanRowStep(const RangeImage& image) {
  if (image.elevations.size() < 2) return kSingleRowStep;
  return std::max(1e-4f, image.meanRowSpacing());
}

}  // namespace

LinkRules::LinkRules(const ObjectOptions& options, const RangeImage& image)
    : columnStep(2.0f * static_cast<float>(M_PI) / static_cast<float>(std::max(1, image.columns))),
      rowStep(meanRowStep(image)),
      rows(image.rows),
      columns(image.columns),
      rowWindow(options.rowWindow),
      maxHeightGap(static_cast<float>(options.maxHeightGap)),
      surfaceDistance(static_cast<float>(options.surfaceDistance)),
      surfaceDepth(static_cast<float>(options.surfaceDepth)),
      options_(options) {
  horizontal =
      distance(options.horizontalDistance,
               std::max(static_cast<float>(options.horizontalAngle), kColumnsSpanned * columnStep));
  vertical = distance(options.verticalDistance,
                      std::max(static_cast<float>(options.verticalAngle), kRowsSpanned * rowStep));
}

LinkRules::Distance LinkRules::distance(double base, float angle) const {
  if (options_.metric == LinkMetric::Constant) {
    return Distance::constant(static_cast<float>(base));
  }
  return {angle, static_cast<float>(options_.nearFactor * base),
          static_cast<float>(options_.farFactor * base), 1.0f};
}

LinkRules LinkRules::shortened(float factor) const {
  LinkRules shorter = *this;
  shorter.horizontal.factor *= factor, shorter.vertical.factor *= factor;
  shorter.surfaceDistance *= factor;
  return shorter;
}

int LinkRules::returnsOn(double size, float range) const {
  const double distance = std::max(range, 0.1f);
  const double columnsHit = size / (distance * columnStep), rowsHit = size / (distance * rowStep);
  return static_cast<int>(std::min(1e6, columnsHit * rowsHit));
}

int LinkRules::minPoints(float range) const {
  return std::max(options_.minPointsFar,
                  std::min(returnsOn(options_.minSize, range), options_.minPointsNear));
}

int LinkRules::minPointsOfPart(float range) const {
  return std::max(minPoints(range), returnsOn(options_.splitMinSize, range));
}

}  // namespace toss
