// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/segmentation/GroundNodeModel.h>
#include <toss/segmentation/GroundOptions.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace toss {

/// Fits the ground planes of nodes one after the other; keeps its buffers.
class GroundNodeFit {
 public:
  explicit GroundNodeFit(const GroundOptions& options) : options_(options) {}

  /// Plane of a node (region-wise ground plane fitting, spec section 2.2): a few rounds of fit and
  /// re-selection, started at the lowest layer of returns that is no reflection.
  GroundNode fit(const NodePoints& points);

  /// Height [m] at which the fit starts: the mean of the lowest returns, above layers so thin that
  /// they are reflections from under the ground (spec section 2.8).
  float lowestLayer(const NodePoints& points);

 private:
  /// A layer of returns no thicker than th_seeds.
  struct Layer {
    float bottom = 0.0f, top = 0.0f;
    std::size_t count = 0;
  };
  void pick(const NodePoints& points);
  float meanOfLowest(float floor) const;
  Layer layerAbove(float floor) const;
  float lowestLayer() const;
  void select(bool asSeeds, float bottom, const GroundNode& node);

  GroundOptions options_;
  /// The returns that are looked at, one of every `stride_`, and how many there are in all.
  std::vector<float> x_, y_, z_;
  std::size_t stride_ = 1, count_ = 0;
  /// Whether each of them takes part in the fit, and those that do.
  std::vector<std::uint8_t> near_;
  std::vector<std::int32_t> selected_;
  std::size_t selectedCount_ = 0;
};

}  // namespace toss
