// SPDX-License-Identifier: BSD-3-Clause
#include "VoterGrid.h"

#include <algorithm>

namespace toss {

namespace {

constexpr std::size_t kSmallestCompaction = 32;

/// Keeps little memory for the next cell of this number: with all of it, every cell would come to
/// hold what the most crowded ever did.
void empty(std::vector<Voter>& voters) {
  constexpr std::size_t kMostKept = 32;
  if (voters.capacity() > kMostKept)
    std::vector<Voter>().swap(voters);
  else
    voters.clear();
}

}  // namespace

VoterGrid::CellIndex VoterGrid::insert(const Voter& voter) {
  const std::int64_t column = coordinate(voter.center.x());
  const std::int64_t row = coordinate(voter.center.y());
  const auto [place, isNew] = indexOf_.try_emplace(key(column, row), 0u);
  if (isNew) {
    if (free_.empty()) {
      free_.push_back(static_cast<CellIndex>(cells_.size()));
      cells_.emplace_back();
    }
    place.value() = free_.back();
    free_.pop_back();
    cells_[place->second].column = column;
    cells_[place->second].row = row;
  }
  cells_[place->second].voters.push_back(voter);
  return place->second;
}

void VoterGrid::removeEarliest(CellIndex index) {
  VoterCell& cell = cells_[index];
  ++cell.first;
  if (cell.first == cell.voters.size()) {
    indexOf_.erase(key(cell.column, cell.row));
    empty(cell.voters), empty(cell.pending);
    cell.first = 0, cell.dynamicVoters = 0;
    free_.push_back(index);
  } else if (cell.first >= kSmallestCompaction && 2 * cell.first >= cell.voters.size()) {
    cell.voters.erase(cell.voters.begin(),
                      cell.voters.begin() + static_cast<std::ptrdiff_t>(cell.first));
    cell.first = 0;
  }
}

const Voter& VoterGrid::find(CellIndex index, BoxId box) const {
  const VoterCell& cell = cells_[index];
  // Mostly a box of the latest scan, which is among the last.
  const Voter* last = cell.end() - 1;
  for (int step = 0; step < 3 && last->id > box; ++step) --last;
  if (last->id == box) return *last;
  return *std::lower_bound(cell.begin(), last, box,
                           [](const Voter& voter, BoxId id) { return voter.id < id; });
}

}  // namespace toss
