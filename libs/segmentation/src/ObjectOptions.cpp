// SPDX-License-Identifier: BSD-3-Clause
#include <toss/segmentation/ObjectOptions.h>

namespace toss {
namespace {

void visitLinks(ObjectOptions& options, OptionVisitor& visitor) {
  visitor.choice({"metric", "", "link distances that grow with range, or the same at every range",
                  "spec section 3.3; constant: TRAVEL"},
                 options.metric, {"adaptive", "constant"});
  visitor.real({"horizontal_distance", "m",
                "base distance that links returns of one row; larger merges more",
                "TRAVEL, spec section 3.6"},
               options.horizontalDistance, 0.01, 10.0);
  visitor.real({"vertical_distance", "m",
                "base horizontal distance that links returns of different rows; larger merges more",
                "TRAVEL, spec section 3.6"},
               options.verticalDistance, 0.01, 10.0);
  visitor.real({"near_factor", "",
                "least adaptive distance as multiple of the base; larger merges more near by",
                "spec section 3.3"},
               options.nearFactor, 0.01, 1.0);
  visitor.real({"far_factor", "",
                "greatest adaptive distance as multiple of the base; larger merges more far out",
                "spec section 3.3"},
               options.farFactor, 1.0, 10.0);
  visitor.real(
      {"horizontal_angle", "rad", "adaptive distance within a row over range; larger merges more",
       "spec section 3.3, widened on real and simulated scans"},
      options.horizontalAngle, 0.001, 0.5);
  visitor.real(
      {"vertical_angle", "rad", "adaptive distance between rows over range; larger merges more",
       "spec section 3.3, widened on real and simulated scans"},
      options.verticalAngle, 0.001, 0.5);
  visitor.integer({"row_window", "rows", "how many rows up and down a link reaches",
                   "TRAVEL, spec section 3.6"},
                  options.rowWindow, 1, 64);
  visitor.real(
      {"max_height_gap", "m", "greatest height difference of a link that crosses rows in between",
       "spec section 2.8"},
      options.maxHeightGap, 0.0, 1000.0);
  visitor.real(
      {"surface_distance", "m",
       "neighbouring returns on a grazed surface are linked up to this distance; 0 = never",
       "measured: keeps bonnets and windscreens with their car"},
      options.surfaceDistance, 0.0, 5.0);
  visitor.real({"surface_depth", "m", "where both lie this far below the sensor", "measured"},
               options.surfaceDepth, 0.0, 100.0);
}

void visitCoverage(ObjectOptions& options, OptionVisitor& visitor) {
  visitor.real(
      {"pixel_merge", "m", "returns of one pixel nearer in range than this are one surface",
       "spec section 1.5"},
      options.pixelMerge, 0.0, 10.0);
  visitor.real(
      {"attach_distance", "m", "a return left over joins an instance that is this near; 0 = never",
       "spec section 11"},
      options.attachDistance, 0.0, 2.0);
  visitor.integer({"min_points_near", "returns", "fewest returns of an instance near the sensor",
                   "TRAVEL, spec section 3.6"},
                  options.minPointsNear, 1, 10000);
  visitor.integer(
      {"min_points_far", "returns", "fewest returns of an instance far out", "spec section 11"},
      options.minPointsFar, 1, 10000);
  visitor.real(
      {"min_size", "m", "edge of the square whose number of returns is the limit between the two",
       "spec section 11"},
      options.minSize, 0.0, 10.0);
  visitor.integer(
      {"max_points", "returns", "clusters with more returns stay without instance; 0 = no limit",
       "spec section 11; TRAVEL: 30000"},
      options.maxPoints, 0, 100000000);
}

void visitSplit(ObjectOptions& options, OptionVisitor& visitor) {
  visitor.real({"split_extent", "m", "clusters longer than this are clustered again; 0 = never",
                "spec section 3.4"},
               options.splitExtent, 0.0, 10000.0);
  visitor.real(
      {"split_factor", "", "factor on the link distances when clustering again; smaller cuts more",
       "spec section 3.4"},
      options.splitFactor, 0.05, 1.0);
  visitor.real({"split_min_size", "m",
                "edge of the square whose number of returns a part needs; larger cuts less",
                "chosen on real and simulated scans"},
               options.splitMinSize, 0.0, 10.0);
}

}  // namespace

void ObjectOptions::visit(OptionVisitor& visitor) {
  visitLinks(*this, visitor);
  visitCoverage(*this, visitor);
  visitSplit(*this, visitor);
}

}  // namespace toss
