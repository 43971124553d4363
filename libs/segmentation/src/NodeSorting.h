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
  NodePoints ofFine(int node) const {
    return atPlace(placeOfFine_[static_cast<std::size_t>(node)]);
  }
  /// Fine node of each return, -1 for those that were left out, shape [n].
  const std::vector<std::int32_t>& nodeOfReturns() const { return node_; }
  int fineAtPlace(int place) const { return fineAtPlace_[static_cast<std::size_t>(place)]; }
  int finePerCoarse() const { return share_; }
  /// Places that hold returns, ascending.
  const std::vector<int>& occupied() const { return occupied_; }
  int places() const { return static_cast<int>(fineAtPlace_.size()); }

 private:
  /// Finds the stretches: consecutive returns of the scan that fall into one node, as beams sweep
  /// across the nodes, or into none.
  void findStretches(const LevelPoints& points, const std::vector<PointClass>& pointClass);
  void scatter(const LevelPoints& points);
  bool startsStretch(std::size_t i) const { return (i == 0) | (node_[i] != node_[i - (i > 0)]); }
  std::int32_t length(std::size_t stretch) const { return start_[stretch + 1] - start_[stretch]; }
  /// Returns of no node are kept at a place after all others.
  std::size_t placeOf(std::size_t stretch) const {
    const std::int32_t node = node_[static_cast<std::size_t>(start_[stretch])];
    return node < 0 ? placeOfFine_.size()
                    : static_cast<std::size_t>(placeOfFine_[static_cast<std::size_t>(node)]);
  }
  std::size_t begin(int place) const {
    return static_cast<std::size_t>(begin_[static_cast<std::size_t>(place)]);
  }
  NodePoints between(int first, int last) const {
    return {points_.data() + begin(first), begin(last) - begin(first)};
  }

  const TriGridField& fine_;
  int share_;
  std::vector<std::int32_t> placeOfFine_, fineAtPlace_;
  std::vector<std::int32_t> node_;
  /// First return of each stretch, and the number of returns; and what is added to the index of a
  /// return of each to get where it is kept.
  std::vector<std::int32_t> start_, shift_;
  std::vector<std::int32_t> begin_, cursor_;
  std::vector<int> occupied_;
  std::vector<NodePoint> points_;
};

}  // namespace toss
