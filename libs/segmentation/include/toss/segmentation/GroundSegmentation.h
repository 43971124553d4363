// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/segmentation/GroundOptions.h>
#include <toss/segmentation/RangeImage.h>
#include <toss/segmentation/Segmentation.h>

#include <memory>

namespace toss {

struct GroundNode;
class TriGridField;

/// Stage 2: which returns lie on the traversable ground, and how high over it the others are
/// (TRAVEL's traversable ground segmentation; spec section 2). Keeps its buffers from scan to scan.
class GroundSegmentation {
 public:
  /// Throws UserError for options out of range.
  explicit GroundSegmentation(const GroundOptions& options);
  ~GroundSegmentation();
  GroundSegmentation(GroundSegmentation&&) noexcept;

  /// Sets Ground and BelowGround in `segmentation.pointClass` (which the projection has filled) on
  /// returns that are neither Invalid nor OutOfRange, and leaves the others Unclustered.
  /// heightAboveGround becomes the distance from the local ground plane wherever there is one, and
  /// nearbyGround what is known about it elsewhere.
  void segment(const LevelPoints& points, const RangeImage& image, Segmentation& segmentation);

  /// The field and its nodes as the last call left them, for tests and viewers.
  const TriGridField& field() const;
  const std::vector<GroundNode>& nodes() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace toss
