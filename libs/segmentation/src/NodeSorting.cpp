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
  findStretches(points, pointClass);
  begin_.assign(placeOfFine_.size() + 1, 0);
  for (const Stretch& stretch : stretches_) begin_[stretch.place + 1] += stretch.count();
  for (std::size_t place = 1; place < begin_.size(); ++place) begin_[place] += begin_[place - 1];
  cursor_.assign(begin_.begin(), begin_.end() - 1);
  const auto count = static_cast<std::size_t>(begin_.back());
  x_.resize(count), y_.resize(count), z_.resize(count), original_.resize(count);
  for (const Stretch& stretch : stretches_) {
    auto to = static_cast<std::size_t>(cursor_[stretch.place]);
    cursor_[stretch.place] += stretch.count();
    for (std::int32_t i = stretch.begin; i < stretch.end; ++i, ++to) {
      const auto from = static_cast<std::size_t>(i);
      x_[to] = points.x[from], y_[to] = points.y[from], z_[to] = points.z[from];
      original_[to] = i;
    }
  }
}

void NodeSorting::findStretches(const LevelPoints& points,
                                const std::vector<PointClass>& pointClass) {
  const std::size_t n = points.x.size();
  node_.resize(n);
  // Loops of their own, without branches, that are vectorised.
  for (std::size_t i = 0; i < n; ++i) node_[i] = fine_.nodeOf(points.x[i], points.y[i]);
  for (std::size_t i = 0; i < n; ++i) {
    node_[i] = pointClass[i] == PointClass::Unclustered ? node_[i] : -1;
  }
  stretches_.clear();
  for (std::size_t i = 0; i < n;) {
    const std::int32_t node = node_[i];
    const std::size_t begin = i;
    while (i < n && node_[i] == node) ++i;
    if (node < 0) continue;
    stretches_.push_back({static_cast<std::size_t>(placeOfFine_[static_cast<std::size_t>(node)]),
                          static_cast<std::int32_t>(begin), static_cast<std::int32_t>(i)});
  }
}

}  // namespace toss
