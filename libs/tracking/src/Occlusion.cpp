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
    const std::int32_t* const points = image_.representative.data() + image_.pixel(row, 0);
    // The neighbour of the first column is the last one: the row closes at the rear.
    int previous = image_.columns - 1;
    while (previous >= 0 && points[previous] == RangeImage::kNone) --previous;
    if (previous < 0) return;
    Neighbour left = neighbour(points[previous]);
    previous -= image_.columns;
    for (int column = 0; column < image_.columns; ++column) {
      if (points[column] == RangeImage::kNone) continue;
      const Neighbour right = neighbour(points[column]);
      if (column - previous > kGap + 1) {
        compare(left, Neighbour());
        compare(Neighbour(), right);
      } else if (left.instance != right.instance) {
        compare(left, right);
      }
      previous = column, left = right;
    }
  }

  RunEnds left(std::size_t instance) const { return left_[instance]; }
  RunEnds right(std::size_t instance) const { return right_[instance]; }

 private:
  /// A return, or none.
  struct Neighbour {
    std::int32_t point = RangeImage::kNone;
    std::size_t instance = 0;
  };
  Neighbour neighbour(std::int32_t point) const {
    return {point,
            static_cast<std::size_t>(segmentation_.instance[static_cast<std::size_t>(point)])};
  }

  /// Columns grow clockwise: the neighbour in the column before lies to the left.
  void compare(const Neighbour& left, const Neighbour& right) {
    const float difference = rangeOf(right.point) - rangeOf(left.point);
    if (left.instance != 0) right_[left.instance].count(-difference > kNearer);
    if (right.instance != 0) left_[right.instance].count(difference > kNearer);
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
