// SPDX-License-Identifier: BSD-3-Clause
#include <toss/geometry/MarkedWords.h>
#include <toss/geometry/ProcessorVariants.h>
#include <toss/tracking/Occlusion.h>

#include <algorithm>
#include <cstdint>
#include <vector>

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

/// Marks where runs of one instance end: between return i - 1 of a row and return i, if either is
/// in an instance. The compiler vectorises this only as a function of arrays that are known not to
/// overlap.
TOSS_ALSO_FOR_AVX2
void findEnds(const std::int32_t* __restrict instance, const std::int32_t* __restrict column,
              std::size_t n, std::uint8_t* __restrict ends) {
  for (std::size_t i = 1; i < n; ++i) {
    const bool differ = (instance[i] != instance[i - 1]) | (column[i] - column[i - 1] > kGap + 1);
    const bool any = (instance[i] | instance[i - 1]) != 0;
    ends[i] = static_cast<std::uint8_t>(differ & any);
  }
}

class OcclusionCount {
 public:
  OcclusionCount(const RangeImage& image, const Segmentation& segmentation)
      : image_(image),
        segmentation_(segmentation),
        left_(static_cast<std::size_t>(segmentation.instanceCount) + 1),
        right_(left_.size()) {
    const std::size_t most = static_cast<std::size_t>(image.columns) + 2;
    point_.resize(most), column_.resize(most), instance_.resize(most);
    ends_.resize(roundedToBlocks(most));
  }

  void countRow(int row) {
    const std::size_t n = takeRow(row);
    if (n < 2) return;
    std::fill(ends_.begin(), ends_.end(), std::uint8_t{0});
    findEnds(instance_.data(), column_.data(), n, ends_.data());
    visitMarks(ends_.data(), ends_.size(), [&](std::size_t i) { countEnd(i); });
  }

  RunEnds left(std::size_t instance) const { return left_[instance]; }
  RunEnds right(std::size_t instance) const { return right_[instance]; }

 private:
  /// Columns grow clockwise: return i - 1 lies to the left of return i. What no one asks for is
  /// counted for instance 0: choices would mostly be mispredicted.
  void countEnd(std::size_t i) {
    const bool adjacent = column_[i] - column_[i - 1] <= kGap + 1;
    const float difference = rangeOf(point_[i]) - rangeOf(point_[i - 1]);
    right_[at(instance_[i - 1])].count(adjacent & (-difference > kNearer));
    left_[at(instance_[i])].count(adjacent & (difference > kNearer));
  }

  static std::size_t at(std::int32_t index) { return static_cast<std::size_t>(index); }
  float rangeOf(std::int32_t point) const { return image_.range[at(point)]; }

  /// Takes the returns of a row, after the last one in the place of the neighbour of the first
  /// column: the row closes at the rear. In one pass without branches, as no one could foretell
  /// which pixels are empty. Returns how many there are.
  std::size_t takeRow(int row) {
    const std::int32_t* const points = image_.representative.data() + image_.pixel(row, 0);
    const std::int32_t* const instances = segmentation_.instance.data();
    std::int32_t *const point = point_.data(), *const where = column_.data();
    std::int32_t* const instance = instance_.data();
    const int columns = image_.columns;
    std::size_t n = 1;
    for (int column = 0; column < columns; ++column) {
      const std::int32_t each = points[column];
      point[n] = each, where[n] = column, instance[n] = instances[std::max(each, 0)];
      n += each == RangeImage::kNone ? 0 : 1;
    }
    if (n == 1) return 0;
    point[0] = point[n - 1], where[0] = where[n - 1] - columns, instance[0] = instance[n - 1];
    return n;
  }

  const RangeImage& image_;
  const Segmentation& segmentation_;
  std::vector<RunEnds> left_, right_;
  /// Of the returns of a row.
  std::vector<std::int32_t> point_, column_, instance_;
  std::vector<std::uint8_t> ends_;
};

}  // namespace

void measureOcclusion(const RangeImage& image, const Segmentation& segmentation,
                      std::vector<Detection>& detections) {
  if (segmentation.instance.empty()) return;
  OcclusionCount count(image, segmentation);
  for (int row = 0; row < image.rows; ++row) count.countRow(row);
  for (Detection& detection : detections) {
    const auto instance = static_cast<std::size_t>(detection.instance);
    detection.occludedLeft = count.left(instance).hiddenShare();
    detection.occludedRight = count.right(instance).hiddenShare();
  }
}

}  // namespace toss
