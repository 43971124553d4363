// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/segmentation/ObjectOptions.h>
#include <toss/segmentation/RangeImage.h>
#include <toss/segmentation/Segmentation.h>

#include <memory>

namespace toss {

/// Stage 3 of the method: clusters the returns above ground into instances. Links and result are
/// those of TRAVEL's above-ground object segmentation made exact with union-find; and no return is
/// dropped (paper section "Above-Ground Object Segmentation", spec sections 3.3 and 11).
/// Keeps its buffers from scan to scan; one per thread.
class ObjectSegmentation {
 public:
  /// Throws UserError for options out of range.
  explicit ObjectSegmentation(const ObjectOptions& options);
  ~ObjectSegmentation();
  ObjectSegmentation(ObjectSegmentation&&) noexcept;
  ObjectSegmentation& operator=(ObjectSegmentation&&) noexcept;

  /// Clusters the points that `segmentation` holds as Unclustered and `image` has a pixel for, and
  /// makes those in an instance Instance. Fills `instance` (numbered by the instance's first pixel,
  /// row by row from the top), `instanceCount`, `members` and `memberBegin`; other classes stay.
  /// Throws std::logic_error where the three arguments are not of one scan.
  void segment(const LevelPoints& points, const RangeImage& image, Segmentation& segmentation);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace toss
