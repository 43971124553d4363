// SPDX-License-Identifier: BSD-3-Clause
#include <toss/segmentation/GroundOptions.h>

namespace toss {
namespace {

void visitField(GroundOptions& options, OptionVisitor& visitor) {
  visitor.real({"extent", "m",
                "Half the side of the square around the sensor in which ground is looked for; "
                "returns farther out are never ground.",
                "TRAVEL kitti_params, spec 2.6"},
               options.extent, 1.0, 500.0);
  visitor.real({"cell_size", "m",
                "Side of a square of the field, which holds four planes. A larger value bridges "
                "sparser returns, a smaller one follows rougher ground.",
                "spec 2.6, 2.8"},
               options.cellSize, 0.2, 50.0);
}

void visitPlanes(GroundOptions& options, OptionVisitor& visitor) {
  visitor.integer(
      {"num_iter", "", "Rounds of plane fit and re-selection per triangle.", "TRAVEL, spec 2.2"},
      options.iterations, 1, 20);
  visitor.integer({"num_lpr", "",
                   "Lowest returns whose mean height starts the fit. A larger value resists "
                   "single low outliers.",
                   "TRAVEL, spec 2.2"},
                  options.lowestPoints, 1, 64);
  visitor.integer({"num_min_pts", "",
                   "Returns that a triangle needs for a plane of its own; others get theirs from "
                   "the terrain around.",
                   "TRAVEL, spec 2.2"},
                  options.minPoints, 3, 10000);
  visitor.integer({"max_fit_pts", "",
                   "Most returns of a triangle that its fit looks at, evenly picked; 0 takes all, "
                   "which is slower and fits no better.",
                   "measured; 0 = TRAVEL"},
                  options.maxFitPoints, 0, 1000000);
  visitor.real({"th_seeds", "m",
                "Height above the lowest returns up to which returns start the fit. A larger value "
                "suits steeper ground.",
                "TRAVEL, spec 2.2"},
               options.seedHeight, 0.01, 10.0);
  visitor.real({"min_layer_share", "",
                "A layer of returns with less than this share of the layer above it, and a gap "
                "between them, is a reflection from under the ground. 0 believes every layer.",
                "spec 2.8"},
               options.minLayerShare, 0.0, 1.0);
  visitor.real({"th_dist", "m",
                "Distance above the plane up to which a return is ground. A larger value takes "
                "more of rough ground, and more of feet and tyres.",
                "TRAVEL, spec 2.5"},
               options.groundHeight, 0.01, 2.0);
  visitor.real(
      {"th_outlier", "m", "Depth under the plane from which a return lies below the ground.",
       "TRAVEL, spec 2.5"},
      options.outlierDepth, 0.01, 10.0);
  visitor.real({"min_buried_path", "m",
                "Length that a beam must have run under the ground, having passed through ground "
                "that others meet, for its return to be below it; shorter ones end in ditches and "
                "beyond edges. 0 asks for neither.",
                "measured, spec 2.8; 0 = TRAVEL"},
               options.minBuriedPath, 0.0, 100.0);
  visitor.real({"th_normal", "",
                "Least vertical component of a plane's normal: cosine of the steepest slope that "
                "is ground (0.94: 20 degrees, 0.80: 37 degrees).",
                "spec 2.2, 2.8, 11"},
               options.minNormalZ, 0.1, 1.0);
  visitor.real({"min_spread", "m",
                "Least spread of a plane's returns across their main direction; those of a single "
                "beam lie on a line and fix no plane. A larger value leaves more to the terrain "
                "model.",
                "measured; 0 = TRAVEL"},
               options.minSpread, 0.0, 10.0);
}

void visitSearch(GroundOptions& options, OptionVisitor& visitor) {
  visitor.real({"th_weight", "",
                "Least weight of a patch that the search does not reach, for squares of 8 m; it "
                "scales with their area.",
                "TRAVEL, ambiguity 7"},
               options.islandWeight, 0.0, 1e9);
  visitor.real({"th_lcc_normal", "rad/m",
                "Change of the normal from patch to patch, per metre between them, that is "
                "traversable.",
                "TRAVEL, spec 2.3"},
               options.convexityNormal, 0.0, 1.6);
  visitor.real({"th_lcc_planar", "rad",
                "Slope from patch to patch, relative to either plane, that is traversable.",
                "TRAVEL, spec 2.3"},
               options.convexityPlanar, 0.0, 1.6);
  visitor.choice({"edge_policy", "",
                  "A patch is not traversable when no reached neighbour leads to it (any_edge) or "
                  "when the first one does not (first_edge).",
                  "ambiguity 8"},
                 options.edgePolicy, {"any_edge", "first_edge"});
  visitor.choice({"island_policy", "", "Patches that the search does not reach: ground or not.",
                  "ambiguity 7"},
                 options.islandPolicy, {"accept_if_weight", "accept", "reject"});
}

void visitTerrain(GroundOptions& options, OptionVisitor& visitor) {
  visitor.flag({"refine_mode", "",
                "Replace each plane by the terrain model through all patches, which revives "
                "triangles between ground.",
                "TRAVEL, spec 2.4"},
               options.refine);
  visitor.integer({"terrain_rounds", "",
                   "Rounds in which the terrain model is fitted to all ground returns at once; 0 "
                   "keeps the average of the patches. Needs refine_mode.",
                   "measured; 0 = TRAVEL"},
                  options.terrainRounds, 0, 4);
  visitor.integer(
      {"reach_rounds", "",
       "Rounds in which sensors of few rows carry the terrain on over ground that they "
       "meet in single rings, a patch further in each; 0 = never. Needs terrain_rounds.",
       "measured on simulated scans"},
      options.reachRounds, 0, 20);
  visitor.real({"reach_spacing", "deg", "Spacing of rows from which on reach_rounds counts.",
                "measured on simulated scans"},
               options.reachSpacing, 0.0, 90.0);
  visitor.integer({"subdivision", "",
                   "Squares of the terrain model along a side of a square of the field. A larger "
                   "value follows kerbs and bumps more closely.",
                   "measured"},
                  options.subdivision, 1, 16);
}

void visitContact(GroundOptions& options, OptionVisitor& visitor) {
  visitor.real({"contact_height", "m",
                "Height over the ground above which a return can be the foot or tyre of what the "
                "beams right above it meet. A smaller value gives more to objects.",
                "measured, spec 11.1"},
               options.contactHeight, 0.0, 1.0);
  visitor.real({"contact_slope", "",
                "Least slope (rise over run) of the line from such a return up to its object; 0 "
                "leaves all of them ground.",
                "measured; 0 = TRAVEL"},
               options.contactSlope, 0.0, 100.0);
}

}  // namespace

void GroundOptions::visit(OptionVisitor& visitor) {
  visitField(*this, visitor);
  visitPlanes(*this, visitor);
  visitSearch(*this, visitor);
  visitTerrain(*this, visitor);
  visitContact(*this, visitor);
}

}  // namespace toss
