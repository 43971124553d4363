// SPDX-License-Identifier: BSD-3-Clause
#include "NodeSorting.h"

namespace toss {

NodeSorting::NodeSorting(const TriGridField& coarse, const TriGridField& fine, int factor)
    : fine_(fine), share_(factor * factor) {
  const auto places = static_cast<std::size_t>(fine.nodes());
  placeOfFine_.resize(places), fineAtPlace_.resize(places), begin_.assign(places + 1, 0);
  std::vector<std::int32_t> filled(static_cast<std::size_t>(coarse.nodes()), 0);
  for (int node = 0; node < fine.nodes(); ++node) {
    const Eigen::Vector2f centroid = fine.centroidOf(node);
    const int outer = coarse.nodeOf(centroid.x(), centroid.y());
    const int place = outer * share_ + filled[static_cast<std::size_t>(outer)]++;
    placeOfFine_[static_cast<std::size_t>(node)] = place;
    fineAtPlace_[static_cast<std::size_t>(place)] = node;
  }
}

void NodeSorting::sort(const LevelPoints& points, const std::vector<PointClass>& pointClass) {
  const std::size_t n = points.x.size();
  place_.resize(n);
  begin_.assign(placeOfFine_.size() + 1, 0);
  // A loop of its own, without branches, that is vectorised.
  for (std::size_t i = 0; i < n; ++i) place_[i] = fine_.nodeOf(points.x[i], points.y[i]);
  for (std::size_t i = 0; i < n; ++i) {
    const bool open = pointClass[i] == PointClass::Unclustered && place_[i] >= 0;
    place_[i] = open ? placeOfFine_[static_cast<std::size_t>(place_[i])] : -1;
    if (open) ++begin_[static_cast<std::size_t>(place_[i]) + 1];
  }
  for (std::size_t place = 1; place < begin_.size(); ++place) begin_[place] += begin_[place - 1];
  cursor_.assign(begin_.begin(), begin_.end() - 1);
  const auto count = static_cast<std::size_t>(begin_.back());
  x_.resize(count), y_.resize(count), z_.resize(count), original_.resize(count);
  for (std::size_t i = 0; i < n; ++i) {
    if (place_[i] < 0) continue;
    const auto to = static_cast<std::size_t>(cursor_[static_cast<std::size_t>(place_[i])]++);
    x_[to] = points.x[i], y_[to] = points.y[i], z_[to] = points.z[i];
    original_[to] = static_cast<std::int32_t>(i);
  }
}

}  // namespace toss
