// SPDX-License-Identifier: BSD-3-Clause
#include "NodeSorting.h"

namespace toss {

void NodeSorting::sort(const LevelPoints& points, const std::vector<PointClass>& pointClass,
                       const TriGridField& field) {
  const std::size_t n = points.x.size();
  node_.resize(n);
  begin_.assign(static_cast<std::size_t>(field.nodes()) + 1, 0);
  for (std::size_t i = 0; i < n; ++i) {
    const bool open = pointClass[i] == PointClass::Unclustered;
    node_[i] = open ? field.nodeOf(points.x[i], points.y[i]) : -1;
    if (node_[i] >= 0) ++begin_[static_cast<std::size_t>(node_[i]) + 1];
  }
  for (std::size_t node = 1; node < begin_.size(); ++node) begin_[node] += begin_[node - 1];
  cursor_.assign(begin_.begin(), begin_.end() - 1);
  const auto count = static_cast<std::size_t>(begin_.back());
  x_.resize(count), y_.resize(count), z_.resize(count), original_.resize(count);
  for (std::size_t i = 0; i < n; ++i) {
    if (node_[i] < 0) continue;
    const auto place = static_cast<std::size_t>(cursor_[static_cast<std::size_t>(node_[i])]++);
    x_[place] = points.x[i], y_[place] = points.y[i], z_[place] = points.z[i];
    original_[place] = static_cast<std::int32_t>(i);
  }
}

}  // namespace toss
