// SPDX-License-Identifier: BSD-3-Clause
#include "RunGrouping.h"

#include <algorithm>
#include <numeric>

namespace toss {

const std::vector<RunGrouping::Group>& RunGrouping::byOwnerAndBrick(
    const std::vector<VoxelRun>& runs) {
  numberGroups(runs);
  rankGroups();
  const std::size_t count = names_.size();
  place_.assign(count + 1, 0);
  for (std::uint32_t& group : groupOfRun_) {
    group = rank_[group];
    ++place_[group + 1];
  }
  std::partial_sum(place_.begin(), place_.end(), place_.begin());
  if (runsByGroup_.size() < runs.size()) runsByGroup_.resize(runs.size());
  for (std::size_t run = 0; run < runs.size(); ++run)
    runsByGroup_[place_[groupOfRun_[run]]++] = runs[run];
  groups_.resize(count);
  const VoxelRun* begin = runsByGroup_.data();
  for (std::size_t group = 0; group < count; ++group) {
    groups_[group] = {begin, runsByGroup_.data() + place_[group]};
    begin = groups_[group].end;
  }
  return groups_;
}

void RunGrouping::numberGroups(const std::vector<VoxelRun>& runs) {
  constexpr std::size_t kLeastTable = 256;
  names_.clear();
  table_.assign(kLeastTable, 0);
  groupOfRun_.resize(runs.size());
  Name last{0, ~VoxelKey{0}};
  std::uint32_t number = 0;
  for (std::size_t run = 0; run < runs.size(); ++run) {
    const Name name{runs[run].owner, runs[run].sum.key >> kBrickShift};
    if (!(name == last)) number = numberOf(name);
    last = name;
    groupOfRun_[run] = number;
  }
}

std::uint32_t RunGrouping::numberOf(const Name& name) {
  const std::size_t mask = table_.size() - 1;
  std::size_t slot = hash(name) & mask;
  for (; table_[slot] != 0; slot = (slot + 1) & mask)
    if (names_[table_[slot] - 1] == name) return table_[slot] - 1;
  names_.push_back(name);
  const auto number = static_cast<std::uint32_t>(names_.size());
  table_[slot] = number;
  if (2 * names_.size() > table_.size()) growTable();
  return number - 1;
}

void RunGrouping::growTable() {
  table_.assign(4 * table_.size(), 0);
  const std::size_t mask = table_.size() - 1;
  for (std::uint32_t number = 0; number < names_.size();) {
    std::size_t slot = hash(names_[number]) & mask;
    while (table_[slot] != 0) slot = (slot + 1) & mask;
    table_[slot] = ++number;
  }
}

void RunGrouping::rankGroups() {
  order_.resize(names_.size());
  std::iota(order_.begin(), order_.end(), 0u);
  std::sort(order_.begin(), order_.end(),
            [this](std::uint32_t a, std::uint32_t b) { return names_[a] < names_[b]; });
  rank_.resize(order_.size());
  for (std::uint32_t rank = 0; rank < order_.size(); ++rank) rank_[order_[rank]] = rank;
}

}  // namespace toss
