// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/segmentation/GroundNodeModel.h>
#include <toss/segmentation/Segmentation.h>
#include <toss/segmentation/TriGridField.h>

#include <cstdint>
#include <vector>

namespace toss {

/// The returns of a scan grouped by the nodes of two nested fields at once (counting sort), so that
/// those of a node lie side by side in memory, in the order of the scan within each fine node.
class NodeSorting {
 public:
  /// `fine` = coarse.refined(factor); both must outlive this.
  NodeSorting(const TriGridField& coarse, const TriGridField& fine, int factor);

  /// Groups the returns that are Unclustered, i.e. not yet decided, and lie inside the field.
  void sort(const LevelPoints& points, const std::vector<PointClass>& pointClass);

  /// Returns of a node of the coarse field.
  NodePoints ofCoarse(int node) const { return between(node * share_, (node + 1) * share_); }
  /// Returns of the fine node at a place. Places count the fine nodes, those of coarse node c being
  /// c * finePerCoarse() and following.
  NodePoints atPlace(int place) const { return between(place, place + 1); }
  int fineAtPlace(int place) const { return fineAtPlace_[static_cast<std::size_t>(place)]; }
  int finePerCoarse() const { return share_; }
  int places() const { return static_cast<int>(fineAtPlace_.size()); }

 private:
  /// Consecutive returns of the scan that fall into one place: beams sweep across the nodes.
  struct Stretch {
    std::size_t place;
    std::int32_t begin, end;
    std::int32_t count() const { return end - begin; }
  };
  void findStretches(const LevelPoints& points, const std::vector<PointClass>& pointClass);
  std::size_t begin(int place) const {
    return static_cast<std::size_t>(begin_[static_cast<std::size_t>(place)]);
  }
  NodePoints between(int first, int last) const {
    const std::size_t from = begin(first);
    return {x_.data() + from, y_.data() + from, z_.data() + from, begin(last) - from,
            original_.data() + from};
  }

  const TriGridField& fine_;
  int share_;
  std::vector<std::int32_t> placeOfFine_, fineAtPlace_;
  /// Fine node of each return, -1 for none, shape [n].
  std::vector<std::int32_t> node_;
  std::vector<Stretch> stretches_;
  std::vector<std::int32_t> begin_, cursor_, original_;
  std::vector<float> x_, y_, z_;
};

}  // namespace toss
