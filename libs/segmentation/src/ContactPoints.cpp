// SPDX-License-Identifier: BSD-3-Clause
#include <toss/segmentation/ContactPoints.h>

#include <algorithm>
#include <cmath>

namespace toss {
namespace {

/// Beams above a return, and columns to either side, in which its object is looked for.
constexpr int kRows = 2, kColumns = 1;

class Contact {
 public:
  Contact(const LevelPoints& points, const RangeImage& image, const GroundOptions& options,
          Segmentation& segmentation)
      : points_(points),
        image_(image),
        height_(static_cast<float>(options.contactHeight)),
        slope_(static_cast<float>(options.contactSlope)),
        segmentation_(segmentation) {}

  /// Row by row from the top, so that what is released carries what lies under it.
  void run() {
    for (int row = 1; row < image_.rows; ++row) {
      for (int column = 0; column < image_.columns; ++column) {
        for (std::int32_t p = image_.at(row, column); p != RangeImage::kNone;
             p = image_.next[static_cast<std::size_t>(p)]) {
          const auto point = static_cast<std::size_t>(p);
          if (isCandidate(point) && carries(point, row, column)) {
            segmentation_.pointClass[point] = PointClass::Unclustered;
          }
        }
      }
    }
  }

 private:
  bool isCandidate(std::size_t point) const {
    return segmentation_.pointClass[point] == PointClass::Ground &&
           segmentation_.heightAboveGround[point] > height_;
  }

  bool carries(std::size_t point, int row, int column) const {
    for (int above = row - 1; above >= std::max(0, row - kRows); --above) {
      for (int side = -kColumns; side <= kColumns; ++side) {
        const int wrapped = (column + side + image_.columns) % image_.columns;
        const std::int32_t other = image_.at(above, wrapped);
        if (other != RangeImage::kNone && standsOn(static_cast<std::size_t>(other), point)) {
          return true;
        }
      }
    }
    return false;
  }

  bool standsOn(std::size_t upper, std::size_t lower) const {
    if (segmentation_.pointClass[upper] != PointClass::Unclustered) return false;
    const float dx = points_.x[upper] - points_.x[lower], dy = points_.y[upper] - points_.y[lower];
    const float rise = points_.z[upper] - points_.z[lower];
    return rise > 0.0f && rise * rise > slope_ * slope_ * (dx * dx + dy * dy);
  }

  const LevelPoints& points_;
  const RangeImage& image_;
  float height_, slope_;
  Segmentation& segmentation_;
};

}  // namespace

void releaseContactPoints(const LevelPoints& points, const RangeImage& image,
                          const GroundOptions& options, Segmentation& segmentation) {
  if (options.contactSlope > 0.0) Contact(points, image, options, segmentation).run();
}

}  // namespace toss
