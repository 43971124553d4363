// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/Box.h>

#include <vector>

namespace toss {

/// A measured box of a trace.
struct TimedBox {
  /// Time of the scan [s].
  double time = 0.0;
  /// Map frame.
  Box box;
};

/// How the front and the rear face of a trace have moved: straight lines over time, fitted by least
/// squares to the faces' positions along the direction in which the centre moves. An object that
/// moves takes both faces along; a view of something static that grows or shrinks moves one
/// (spec section 6, test d).
struct FaceMotion {
  /// Horizontal displacement of the centre from the first to the last box, by its line [m].
  double displacement = 0.0;
  /// Displacement of the leading and of the lagging face, by their lines [m]; the lagging one's is
  /// negative where it moved backwards.
  double leading = 0.0, lagging = 0.0;
  /// Standard deviation of the faces about their lines, the larger of the two [m].
  double scatter = 0.0;
};

/// Fits at least three boxes with ascending times; fewer give zeros.
FaceMotion fitFaceMotion(const std::vector<TimedBox>& boxes);

/// Half the extent of the footprint along a horizontal unit vector [m].
double reachAlong(const Box& box, const Eigen::Vector2d& direction);

}  // namespace toss
