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

/// The instance at each pixel of a row, -1 where there is no return.
TOSS_ALSO_FOR_AVX2
void findInstances(const std::int32_t* __restrict point, const std::int32_t* __restrict instances,
                   std::size_t n, std::int32_t* __restrict instance) {
  for (std::size_t c = 0; c < n; ++c) {
    const std::int32_t at = instances[std::max(point[c], 0)];
    instance[c] = point[c] == RangeImage::kNone ? -1 : at;
  }
}

/// Marks the pixels of instances whose neighbour on either side is of another or holds no return;
/// `instance` has one pixel more at either end. The compiler vectorises this only as a function of
/// arrays that are known not to overlap.
TOSS_ALSO_FOR_AVX2
void findEnds(const std::int32_t* __restrict instance, std::size_t n,
              std::uint8_t* __restrict ends) {
  for (std::size_t c = 1; c <= n; ++c) {
    const bool differ = (instance[c] != instance[c - 1]) | (instance[c] != instance[c + 1]);
    ends[c - 1] = static_cast<std::uint8_t>(differ & (instance[c] > 0));
  }
}

class OcclusionCount {
 public:
  OcclusionCount(const RangeImage& image, const Segmentation& segmentation)
      : image_(image),
        segmentation_(segmentation),
        columns_(static_cast<std::size_t>(image.columns)),
        left_(static_cast<std::size_t>(segmentation.instanceCount) + 1),
        right_(left_.size()),
        instance_(columns_ + 2),
        ends_(roundedToBlocks(columns_)) {}

  void countRow(int row) {
    points_ = image_.representative.data() + image_.pixel(row, 0);
    findInstances(points_, segmentation_.instance.data(), columns_, instance_.data() + 1);
    // The row closes at the rear.
    instance_.front() = instance_[columns_], instance_.back() = instance_[1];
    findEnds(instance_.data(), columns_, ends_.data());
    visitMarks(ends_.data(), ends_.size(), [&](std::size_t column) { countEnds(column); });
  }

  RunEnds left(std::size_t instance) const { return left_[instance]; }
  RunEnds right(std::size_t instance) const { return right_[instance]; }

 private:
  static std::size_t at(std::int32_t index) { return static_cast<std::size_t>(index); }
  float rangeAt(std::size_t column) const { return image_.range[at(points_[column])]; }

  /// Columns grow clockwise: the one before lies to the left.
  void countEnds(std::size_t column) {
    countEnd(column, columns_ - 1, left_);
    countEnd(column, 1, right_);
  }

  /// Counts the end at a pixel if its next return, some steps of `step` columns on, goes on with
  /// another instance, or is too far for a neighbour.
  void countEnd(std::size_t column, std::size_t step, std::vector<RunEnds>& ends) const {
    const std::int32_t own = instance_[column + 1];
    std::size_t next = column;
    for (int gap = 0; gap <= kGap; ++gap) {
      next = next + step < columns_ ? next + step : next + step - columns_;
      const std::int32_t other = instance_[next + 1];
      if (other == own) return;
      if (other >= 0) return ends[at(own)].count(rangeAt(column) - rangeAt(next) > kNearer);
    }
    ends[at(own)].count(false);
  }

  const RangeImage& image_;
  const Segmentation& segmentation_;
  std::size_t columns_;
  std::vector<RunEnds> left_, right_;
  /// Of the row at hand: its pixels' returns and instances, with one more at either end, and which
  /// of them may be ends.
  const std::int32_t* points_ = nullptr;
  std::vector<std::int32_t> instance_;
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
