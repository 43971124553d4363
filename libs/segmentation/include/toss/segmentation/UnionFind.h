// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace toss {

/// Disjoint sets of the numbers 0..n-1. The representative of a set is its smallest member, so the
/// result does not depend on the order of the unions (spec section 3.3).
class UnionFind {
 public:
  explicit UnionFind(std::size_t n = 0) { reset(n); }

  /// Makes n sets of one member each; keeps the memory.
  void reset(std::size_t n) {
    parent_.resize(n);
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  std::size_t size() const { return parent_.size(); }

  /// A member of the set that `i` is in, and mostly the smallest one, for less. Shortens the path.
  std::int32_t ancestor(std::int32_t i) { return parent(i) = parent(parent(i)); }

  /// Smallest member of the set that `i` is in. Halves the path it walks. The first steps are
  /// taken in any case, as no one could foretell whether one or two are left.
  std::int32_t find(std::int32_t i) {
    i = ancestor(i);
    while (parent(i) != i) i = ancestor(i);
    return i;
  }

  /// Makes one set of the sets of `a` and `b`. Returns whether they were two.
  bool unite(std::int32_t a, std::int32_t b) {
    a = find(a), b = find(b);
    if (a == b) return false;
    uniteRoots(a, b);
    return true;
  }
  /// The same for two smallest members of sets that differ.
  void uniteRoots(std::int32_t a, std::int32_t b) { parent(std::max(a, b)) = std::min(a, b); }

 private:
  std::int32_t& parent(std::int32_t i) { return parent_[static_cast<std::size_t>(i)]; }

  std::vector<std::int32_t> parent_;
};

}  // namespace toss
