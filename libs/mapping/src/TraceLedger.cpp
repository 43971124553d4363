// SPDX-License-Identifier: BSD-3-Clause
#include "TraceLedger.h"

#include <algorithm>

namespace toss {

namespace {

bool before(const VoxelSum& a, const VoxelSum& b) {
  return a.key < b.key;
}

void addTo(VoxelSum& sum, const VoxelContribution& c) {
  sum.count += c.count;
  sum.x += c.x;
  sum.y += c.y;
  sum.z += c.z;
  sum.intensity += c.intensity;
}

/// The first of sorted [first, last) that is not before `key`, found in steps that double: keys are
/// asked for in ascending order, and the next one is mostly near.
std::size_t gallop(const std::vector<VoxelSum>& sums, std::size_t first, std::size_t last,
                   VoxelKey key) {
  std::size_t step = 1;
  while (first + step < last && sums[first + step].key < key) {
    first += step;
    step *= 2;
  }
  const auto begin = sums.begin() + static_cast<std::ptrdiff_t>(first);
  const auto end = sums.begin() + static_cast<std::ptrdiff_t>(std::min(last, first + step + 1));
  const auto found =
      std::partition_point(begin, end, [key](const VoxelSum& s) { return s.key < key; });
  return static_cast<std::size_t>(found - sums.begin());
}

}  // namespace

void TraceLedger::add(const ContributionSpan& contributions) {
  const std::size_t known = sums_.size();
  std::size_t place = 0;
  for (const VoxelContribution* next = contributions.begin; next != contributions.end; ++next) {
    const VoxelContribution& c = *next;
    place = gallop(sums_, place, known, c.key);
    const bool isKnown = place < known && sums_[place].key == c.key;
    if (!isKnown) sums_.push_back({c.key, 0, 0, 0, 0, 0});
    addTo(isKnown ? sums_[place] : sums_.back(), c);
  }
  std::inplace_merge(sums_.begin(), sums_.begin() + static_cast<std::ptrdiff_t>(known), sums_.end(),
                     before);
}

}  // namespace toss
