// SPDX-License-Identifier: BSD-3-Clause
#include <toss/tracking/BoxOptions.h>

namespace toss {
namespace {

void visitShape(BoxOptions& options, OptionVisitor& visitor) {
  visitor.choice({"mode", "", "boxes along the map's axes, or along the outline of the returns",
                  "paper section 3DMOT; spec section 4.2"},
                 options.mode, {"aabb", "lshape"});
  visitor.real({"trim", "", "share of returns cut off at each end of an axis; larger shrinks boxes",
                "spec section 4.3"},
               options.trim, 0.0, 0.2);
  visitor.integer({"trim_points", "returns", "instances with more returns than this are trimmed",
                   "spec section 4.3"},
                  options.trimPoints, 1, 1000000);
  visitor.real({"floor_gap", "m", "the lower face goes down to ground that is this near; 0 = never",
                "spec section 4.3"},
               options.floorGap, 0.0, 10.0);
  visitor.integer({"lshape_points", "returns", "fewest returns that an L-shape is fitted to",
                   "spec section 4.2"},
                  options.lShapePoints, 3, 1000000);
  visitor.real({"lshape_min_side", "m", "shorter instances stay axis-aligned", "spec section 4.2"},
               options.lShapeMinSide, 0.0, 100.0);
  visitor.real({"lshape_max_side", "m", "longer instances stay axis-aligned", "spec section 4.2"},
               options.lShapeMaxSide, 0.0, 100.0);
}

void visitBackground(BoxOptions& options, OptionVisitor& visitor) {
  visitor.real({"max_extent", "m", "longer or wider instances are background and never tracked",
                "spec section 3.4"},
               options.maxExtent, 1.0, 10000.0);
  visitor.real({"max_height", "m",
                "higher instances with more than max_footprint are background and never tracked",
                "spec section 3.4, above the height of trucks"},
               options.maxHeight, 0.5, 10000.0);
  visitor.real(
      {"max_footprint", "m^2", "footprint from which on max_height counts", "spec section 3.4"},
      options.maxFootprint, 0.0, 1e8);
  visitor.real(
      {"max_clearance", "m",
       "instances that begin higher above ground are background: never tracked, and static "
       "whatever other scans see through them",
       "measured on simulated scans: trucks seen over cars begin lower"},
      options.maxClearance, 0.0, 10000.0);
}

}  // namespace

void BoxOptions::visit(OptionVisitor& visitor) {
  visitShape(*this, visitor);
  visitBackground(*this, visitor);
}

}  // namespace toss
