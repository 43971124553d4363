// SPDX-License-Identifier: BSD-3-Clause
#include <toss/tracking/AssociationCost.h>

#include <algorithm>

namespace toss {

double volumeCost(const Box& a, const Box& b) {
  const double larger = std::max(a.volume(), b.volume());
  return larger > 0.0 ? 1.0 - std::min(a.volume(), b.volume()) / larger : 0.0;
}

AssociationCost associationCost(const Box& a, const Box& b) {
  return {(a.center - b.center).norm(), 1.0 - intersectionOverUnion(a, b), volumeCost(a, b)};
}

Box withMinExtent(const Box& box, double minExtent) {
  Box grown = box;
  grown.length = std::max(box.length, minExtent);
  grown.width = std::max(box.width, minExtent);
  grown.height = std::max(box.height, minExtent);
  return grown;
}

}  // namespace toss
