// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/Options.h>

namespace toss {

/// When a patch of ground counts as not traversable (ambiguity 8).
enum class EdgePolicy {
  AnyEdge,   ///< when no neighbour that is reached leads to it
  FirstEdge  ///< when the first neighbour that reaches it does not lead to it (TRAVEL)
};

/// What becomes of patches that the search never reaches (ambiguity 7).
enum class IslandPolicy {
  AcceptIfWeight,  ///< ground where their weight exceeds th_weight
  Accept,          ///< ground (TRAVEL)
  Reject           ///< not ground
};

/// Ground segmentation on a tri-grid field (TRAVEL's TGS; spec section 2).
struct GroundOptions : Options {
  /// Half the side of the square field around the sensor [m].
  double extent = 64.0;
  /// Side of a square of the field [m]; each square holds four triangles.
  double cellSize = 8.0;
  /// Plane fits per triangle.
  int iterations = 3;
  /// Lowest returns whose mean height starts the fit.
  int lowestPoints = 5;
  /// Returns that a triangle needs for a plane of its own.
  int minPoints = 10;
  /// Most returns of a triangle that its fit looks at, evenly picked; 0 = all.
  int maxFitPoints = 512;
  /// Height above the lowest returns up to which returns start the fit [m].
  double seedHeight = 0.5;
  /// Share of a layer's returns that a layer below it needs, lest it be taken for a reflection; 0
  /// believes every layer.
  double minLayerShare = 0.1;
  /// Distance above the plane up to which a return is ground [m].
  double groundHeight = 0.10;
  /// Depth under the plane from which a return is BelowGround [m].
  double outlierDepth = 0.3;
  /// Least vertical component of a ground plane's normal: cosine of the steepest slope.
  double minNormalZ = 0.80;
  /// Least spread (standard deviation) of a plane's returns across their main direction [m].
  double minSpread = 0.15;
  /// Least weight of an island, for squares of 8 m; it scales with their area.
  double islandWeight = 200.0;
  /// Change of the normal that is traversable [rad per m of distance between the patches].
  double convexityNormal = 0.03;
  /// Slope between patches relative to their planes that is traversable [rad].
  double convexityPlanar = 0.1;
  EdgePolicy edgePolicy = EdgePolicy::AnyEdge;
  IslandPolicy islandPolicy = IslandPolicy::AcceptIfWeight;
  /// Whether planes are replaced by the terrain model through all patches.
  bool refine = true;
  /// Rounds of fitting the terrain model to all ground returns at once; 0 leaves TRAVEL's average.
  int terrainRounds = 2;
  /// Rounds in which the terrain is carried on over ground that is met in single rings, a patch
  /// further in each; 0 = never. Spacing of the sensor's rows from which on this is done [deg].
  int reachRounds = 6;
  double reachSpacing = 0.5;
  /// Squares of the terrain model along a side of a square of the field.
  int subdivision = 4;
  /// Length of a beam under the ground [m] from which its return is BelowGround; less is a ditch.
  double minBuriedPath = 1.5;
  /// Height over the ground [m] above which a return can belong to the object that stands on it.
  double contactHeight = 0.03;
  /// Least slope (rise over run) from such a return to the object above it; 0 leaves it ground.
  double contactSlope = 1.0;

  const char* section() const override { return "ground"; }
  void visit(OptionVisitor& visitor) override;
};

}  // namespace toss
