// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/Options.h>

#include <string>
#include <vector>

namespace toss {

/// How other scans testify about the returns of one scan (spec section 12).
struct VisibilityOptions : Options {
  /// Whether free space is looked at; off, tracking and voting decide alone as in the paper.
  bool enabled = true;
  /// Ages of the views that are asked [s], ascending, apart by spaces; the same before and after.
  std::string offsets = "0.5 0.7 1 1.5 2 3 4.5 6";
  /// Columns of a stored view; its pixels are as wide as the guard around thin structure.
  int columns = 1024;
  /// A view is free where it sees past the return by this much [m] plus this share of the range.
  double freeMargin = 0.4, freeMarginShare = 0.01;
  /// A view is a hit where it measures the return's range within this [m].
  double hitMargin = 0.2;
  /// What a view measures nearer than this share of the return's range is an occluder: it leaves
  /// the verdict to the rest of the neighbourhood. 0 = all that is nearer keeps a return from being
  /// free.
  double occluderShare = 0.33;
  /// Edge of the cells that a scan's returns are thinned to before views are asked [m].
  double cellSize = 0.2;
  /// Most cells of one instance that are asked about, spread over it.
  int maxCells = 48;
  /// Free views that make a cell free.
  int minFreeViews = 2;

  const char* section() const override { return "visibility"; }
  void visit(OptionVisitor& visitor) override;

  /// `offsets` as numbers. Throws UserError where they are not positive and ascending.
  std::vector<double> offsetSeconds() const;
};

}  // namespace toss
