// SPDX-License-Identifier: BSD-3-Clause
#include "VoterGrid.h"

#include <gtest/gtest.h>

namespace toss {
namespace {

TEST(VoterGrid, EmptiedCellsDoNotKeepTheMemoryOfTheMostCrowded) {
  VoterGrid grid(5.0);
  constexpr int kCells = 20, kCrowd = 1000;
  for (int c = 0; c < kCells; ++c) {
    // The cell before was given up: this one takes its number.
    Voter voter;
    voter.center.x() = 5.0 * c + 2.5;
    VoterGrid::CellIndex cell = 0;
    for (int i = 0; i < kCrowd; ++i) {
      ++voter.id;
      cell = grid.insert(voter);
    }
    EXPECT_EQ(cell, 0u);
    EXPECT_EQ(grid.cell(cell).end() - grid.cell(cell).begin(), kCrowd);
    for (int i = 0; i < kCrowd; ++i) grid.removeEarliest(cell);
    EXPECT_EQ(grid.cell(cell).end() - grid.cell(cell).begin(), 0);
    EXPECT_LT(grid.cell(cell).voters.capacity(), 100u);
  }
}

}  // namespace
}  // namespace toss
