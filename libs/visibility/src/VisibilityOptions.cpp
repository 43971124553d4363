// SPDX-License-Identifier: BSD-3-Clause
#include <toss/visibility/VisibilityOptions.h>

#include <sstream>

namespace toss {

void VisibilityOptions::visit(OptionVisitor& v) {
  v.flag({"enabled", "", "Whether views of other scans testify about each return", "spec 12"},
         enabled);
  v.string(
      {"offsets", "s", "Ages of the views that are asked, before and after each scan", "spec 12"},
      offsets);
  v.integer({"columns", "", "Columns of a stored view; fewer guard thin structure more", "spec 12"},
            columns, 64, 4096);
  v.real(
      {"free_margin", "m", "A view is free where it sees past the return by this much", "spec 12"},
      freeMargin, 0.05, 5.0);
  v.real({"free_margin_share", "", "and by this share of the return's range", "spec 12"},
         freeMarginShare, 0.0, 0.2);
  v.real({"hit_margin", "m", "A view is a hit where it measures the return's range this closely",
          "spec 12"},
         hitMargin, 0.02, 2.0);
  v.real({"occluder_share", "",
          "What a view measures nearer than this share of the return's range is an occluder, past "
          "which it may still see; 0 = it never is",
          "measured: half lets edges of walls through, a quarter finds the same movers"},
         occluderShare, 0.0, 0.9);
  v.real({"cell_size", "m", "Returns are thinned to cells of this edge before views are asked",
          "measured: 0.2 keeps the decision of every return"},
         cellSize, 0.05, 1.0);
  v.integer({"max_cells", "", "Most cells of one instance that views are asked about",
             "measured: more change no decision"},
            maxCells, 4, 100000);
  v.integer({"min_free_views", "", "Free views that make a cell free", "spec 12"}, minFreeViews, 1,
            10);
}

std::vector<double> VisibilityOptions::offsetSeconds() const {
  std::istringstream stream(offsets);
  std::vector<double> result;
  for (double offset = 0; stream >> offset;) {
    if (!(offset > (result.empty() ? 0.0 : result.back()) && offset <= 60.0))
      throw UserError("visibility.offsets", "'" + offsets + "' does not ascend from above 0 to 60",
                      "give ages in seconds such as 0.5 1 2 4");
    result.push_back(offset);
  }
  if (!stream.eof())
    throw UserError("visibility.offsets", "'" + offsets + "' holds something that is no number",
                    "give ages in seconds such as 0.5 1 2 4");
  return result;
}

}  // namespace toss
