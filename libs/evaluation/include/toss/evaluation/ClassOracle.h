// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

namespace toss {

/// The best class that any classifier could give to groups of returns: the majority of their true
/// classes (spec section 11). Groups are numbered up to 65535; 0 is "in no group".
class ClassOracle {
 public:
  ClassOracle();
  /// Forgets all counts.
  void clear();
  /// Counts returns: groups[i] of labels, moving or not by their true labels; true class 0 is left
  /// out where `ignoreUnlabelled`. `truth` and `grouped`, whose high 16 bits are the group: shape
  /// [n].
  void add(const std::vector<std::uint32_t>& truth, const std::vector<std::uint32_t>& grouped,
           bool ignoreUnlabelled);
  /// Whether more returns of the group move than stand still. Never for group 0.
  bool moving(std::uint32_t group) const;

 private:
  /// Moving minus static returns, shape [65536].
  std::vector<std::int64_t> balance_;
};

}  // namespace toss
