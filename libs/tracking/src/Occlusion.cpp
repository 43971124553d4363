// SPDX-License-Identifier: BSD-3-Clause
#include <toss/tracking/Occlusion.h>

namespace toss {
namespace {

/// Something hides the rest of an instance if it is nearer by this [m].
constexpr float kNearer = 0.5f;
/// Empty pixels that are skipped on the way to the neighbour.
constexpr int kGap = 4;

/// Ends of an instance's runs on one side: all, and those at something nearer.
struct RunEnds {
  int all = 0, hidden = 0;

  void count(bool isHidden) { ++all, hidden += isHidden ? 1 : 0; }
  float hiddenShare() const {
    return all > 0 ? static_cast<float>(hidden) / static_cast<float>(all) : 0.0f;
  }
};

class OcclusionCount {
 public:
  OcclusionCount(const RangeImage& image, const Segmentation& segmentation)
      : image_(image),
        segmentation_(segmentation),
        left_(static_cast<std::size_t>(segmentation.instanceCount) + 1),
        right_(left_.size()) {}

  void countRow(int row) {
    // The neighbour of the first column is the last one: the row closes at the rear.
    int previous = image_.columns - 1;
    while (previous >= 0 && image_.at(row, previous) == RangeImage::kNone) --previous;
    if (previous < 0) return;
    std::int32_t previousPoint = image_.at(row, previous);
    previous -= image_.columns;
    for (int column = 0; column < image_.columns; ++column) {
      const std::int32_t point = image_.at(row, column);
      if (point == RangeImage::kNone) continue;
      if (column - previous <= kGap + 1) {
        compare(previousPoint, point);
      } else {
        compare(previousPoint, RangeImage::kNone);
        compare(RangeImage::kNone, point);
      }
      previous = column, previousPoint = point;
    }
  }

  RunEnds left(std::size_t instance) const { return left_[instance]; }
  RunEnds right(std::size_t instance) const { return right_[instance]; }

 private:
  /// Columns grow clockwise: the neighbour in the column before lies to the left.
  void compare(std::int32_t leftPoint, std::int32_t rightPoint) {
    const std::size_t leftInstance = instanceOf(leftPoint), rightInstance = instanceOf(rightPoint);
    if (leftInstance == rightInstance) return;
    const float difference = rangeOf(rightPoint) - rangeOf(leftPoint);
    if (leftInstance != 0) right_[leftInstance].count(-difference > kNearer);
    if (rightInstance != 0) left_[rightInstance].count(difference > kNearer);
  }

  std::size_t instanceOf(std::int32_t point) const {
    return point == RangeImage::kNone
               ? 0
               : static_cast<std::size_t>(segmentation_.instance[static_cast<std::size_t>(point)]);
  }

  /// Nothing measured is taken as far away: it hides nothing.
  float rangeOf(std::int32_t point) const {
    return point == RangeImage::kNone ? 1e9f : image_.range[static_cast<std::size_t>(point)];
  }

  const RangeImage& image_;
  const Segmentation& segmentation_;
  std::vector<RunEnds> left_, right_;
};

}  // namespace

void measureOcclusion(const RangeImage& image, const Segmentation& segmentation,
                      std::vector<Detection>& detections) {
  OcclusionCount count(image, segmentation);
  for (int row = 0; row < image.rows; ++row) count.countRow(row);
  for (Detection& detection : detections) {
    const auto instance = static_cast<std::size_t>(detection.instance);
    detection.occludedLeft = count.left(instance).hiddenShare();
    detection.occludedRight = count.right(instance).hiddenShare();
  }
}

}  // namespace toss
