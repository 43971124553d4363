// SPDX-License-Identifier: BSD-3-Clause
#include <toss/geometry/MarkedWords.h>
#include <toss/geometry/ProcessorVariants.h>
#include <toss/segmentation/ContactPoints.h>
#include <toss/segmentation/UprightNeighbours.h>

#include <algorithm>
#include <array>

namespace toss {
namespace {

constexpr std::size_t kBlock = 512;

// The compiler vectorises this only as a function of arrays that are known not to overlap.
TOSS_ALSO_FOR_AVX2
void markHighGround(const PointClass* __restrict pointClass, const float* __restrict height,
                    float least, std::size_t n, std::uint8_t* __restrict mark) {
  for (std::size_t i = 0; i < n; ++i) {
    mark[i] =
        static_cast<std::uint8_t>((pointClass[i] == PointClass::Ground) & (height[i] > least));
  }
}

}  // namespace

void ContactPoints::findCandidates(const Segmentation& segmentation, float height) {
  const std::size_t n = segmentation.pointClass.size();
  if (found_.size() < n + kMarksInWord) found_.resize(n + kMarksInWord);
  count_ = 0;
  std::array<std::uint8_t, kBlock> mark;
  for (std::size_t begin = 0; begin < n; begin += kBlock) {
    const std::size_t size = std::min(kBlock, n - begin);
    mark.fill(0);
    markHighGround(segmentation.pointClass.data() + begin,
                   segmentation.heightAboveGround.data() + begin, height, size, mark.data());
    visitMarkedWords(mark.data(), kBlock, [&](std::size_t first) {
      // Without branches, as no one could foretell on which side of the height a return lies.
      for (std::size_t i = first; i < first + kMarksInWord; ++i) {
        found_[count_] = static_cast<std::int32_t>(begin + i);
        count_ += mark[i];
      }
    });
  }
}

/// A counting sort.
void ContactPoints::sortByRow(const RangeImage& image) {
  const auto rowOf = [&](std::size_t i) {
    return static_cast<std::size_t>(image.row[static_cast<std::size_t>(found_[i])]);
  };
  rowBegin_.assign(static_cast<std::size_t>(image.rows) + 1, 0);
  for (std::size_t i = 0; i < count_; ++i) ++rowBegin_[rowOf(i) + 1];
  for (std::size_t row = 1; row < rowBegin_.size(); ++row) rowBegin_[row] += rowBegin_[row - 1];
  sorted_.resize(count_);
  for (std::size_t i = 0; i < count_; ++i)
    sorted_[static_cast<std::size_t>(rowBegin_[rowOf(i)]++)] = found_[i];
}

void ContactPoints::release(const LevelPoints& points, const RangeImage& image,
                            const GroundOptions& options, Segmentation& segmentation) {
  if (options.contactSlope == 0.0) return;
  findCandidates(segmentation, static_cast<float>(options.contactHeight));
  sortByRow(image);
  const UprightNeighbours neighbours(points, image, static_cast<float>(options.contactSlope));
  const auto isObject = [&](std::size_t point) {
    return segmentation.pointClass[point] == PointClass::Unclustered;
  };
  // From the top, so that what is released carries what lies under it.
  for (const std::int32_t candidate : sorted_) {
    const auto point = static_cast<std::size_t>(candidate);
    if (neighbours.anyAbove(point, isObject)) {
      segmentation.pointClass[point] = PointClass::Unclustered;
    }
  }
}

}  // namespace toss
