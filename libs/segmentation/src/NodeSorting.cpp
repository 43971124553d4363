// SPDX-License-Identifier: BSD-3-Clause
#include "NodeSorting.h"

#include <toss/geometry/ProcessorVariants.h>

namespace toss {
namespace {

// The compiler vectorises this only as a function of arrays that are known not to overlap.
TOSS_ALSO_FOR_AVX2
void findNodes(const TriGridField& field, const float* __restrict x, const float* __restrict y,
               const PointClass* __restrict pointClass, std::size_t n,
               std::int32_t* __restrict node) {
  for (std::size_t i = 0; i < n; ++i) {
    // Found in any case, as only loops without branches are vectorised.
    const std::int32_t noneIfDecided = -static_cast<int>(pointClass[i] != PointClass::Unclustered);
    node[i] = field.nodeOf(x[i], y[i]) | noneIfDecided;
  }
}

}  // namespace

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
  begin_.assign(placeOfFine_.size() + 2, 0);
  for (std::size_t s = 0; s + 1 < start_.size(); ++s) begin_[placeOf(s) + 1] += length(s);
  for (std::size_t place = 1; place < begin_.size(); ++place) begin_[place] += begin_[place - 1];
  occupied_.clear();
  for (int place = 0; place < places(); ++place) {
    if (begin(place + 1) > begin(place)) occupied_.push_back(place);
  }
  cursor_.assign(begin_.begin(), begin_.end() - 1);
  shift_.resize(start_.size());
  for (std::size_t s = 0; s + 1 < start_.size(); ++s) {
    std::int32_t& cursor = cursor_[placeOf(s)];
    shift_[s] = cursor - start_[s];
    cursor += length(s);
  }
  scatter(points);
}

void NodeSorting::findStretches(const LevelPoints& points,
                                const std::vector<PointClass>& pointClass) {
  const std::size_t n = points.x.size();
  node_.resize(n);
  findNodes(fine_, points.x.data(), points.y.data(), pointClass.data(), n, node_.data());
  start_.resize(n + 1);
  std::size_t count = 0;
  for (std::size_t i = 0; i < n; ++i) {
    start_[count] = static_cast<std::int32_t>(i);
    count += startsStretch(i) ? 1 : 0;
  }
  start_[count] = static_cast<std::int32_t>(n);
  start_.resize(count + 1);
}

/// One return after the other, without a branch for the ends of stretches, as these come at random.
void NodeSorting::scatter(const LevelPoints& points) {
  const std::size_t n = points.x.size();
  points_.resize(n);
  NodePoint* const sorted = points_.data();
  std::size_t stretch = 0;
  for (std::size_t i = 0; i < n; ++i) {
    stretch += i > 0 && startsStretch(i) ? 1 : 0;
    const auto point = static_cast<std::int32_t>(i);
    const auto to = static_cast<std::size_t>(point + shift_[stretch]);
    sorted[to] = {points.x[i], points.y[i], points.z[i], point};
  }
}

}  // namespace toss
