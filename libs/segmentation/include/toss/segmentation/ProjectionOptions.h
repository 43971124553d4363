// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/Options.h>

namespace toss {

/// Where the row of a return in the range image comes from.
enum class RowPolicy {
  Automatic,  ///< the ring field; else the ring order of the input; else the elevation
  Elevation,  ///< always the nearest beam of the sensor's table
  Equation    ///< paper Eq. 1: evenly spaced rows between the top and the bottom beam
};

/// Which returns take part, and how they are laid out in the range image (spec sections 1.1-1.4).
struct ProjectionOptions : Options {
  /// Returns nearer than this to the sensor are OutOfRange [m]; 0 = the sensor's own limit.
  double minRange = 0.0;
  /// Returns farther than this from the sensor are OutOfRange [m]; 0 = the sensor's own limit.
  double maxRange = 0.0;
  /// Horizontal radius of the robot's own body around the sensor [m]: returns inside are Invalid.
  /// 0 by default, because what is lost there can be a person beside a small robot; the preset for
  /// cars (HDL-64E) has 2.7.
  double egoRadius = 0.0;
  /// Heights relative to the sensor, in the sensor frame [m], outside of which returns are
  /// OutOfRange. Off by default.
  double minZ = -1000.0, maxZ = 1000.0;
  /// Columns of the range image; 0 = firings per revolution of the sensor.
  int columns = 0;
  RowPolicy rowSource = RowPolicy::Automatic;

  const char* section() const override { return "projection"; }

  void visit(OptionVisitor& visitor) override {
    visitor.real({"min_range", "m",
                  "Nearest range that is used; 0 takes the sensor's own limit. A larger value "
                  "drops more of what is close to the robot.",
                  "spec 1.1"},
                 minRange, 0.0, 1000.0);
    visitor.real({"max_range", "m",
                  "Farthest range that is used; 0 takes the sensor's own limit. A larger value "
                  "brings in sparser returns.",
                  "spec 1.1"},
                 maxRange, 0.0, 1000.0);
    visitor.real({"ego_radius", "m",
                  "Horizontal radius around the sensor inside which returns are the robot's own "
                  "body and are left out of everything; 2.7 for the KITTI car, 0.5 for a "
                  "quadruped, 0 for none.",
                  "spec 1.1"},
                 egoRadius, 0.0, 100.0);
    visitor.real({"min_z", "m",
                  "Lowest height relative to the sensor that is used. A larger value drops more "
                  "reflections from under the ground.",
                  "spec 1.1"},
                 minZ, -1000.0, 1000.0);
    visitor.real({"max_z", "m",
                  "Greatest height relative to the sensor that is used. A smaller value drops "
                  "more of ceilings and trees.",
                  "spec 1.1"},
                 maxZ, -1000.0, 1000.0);
    visitor.integer({"columns", "",
                     "Columns of the range image; 0 takes the firings per revolution of the "
                     "sensor. More columns leave fewer returns in the same pixel but more holes.",
                     "spec 1.5"},
                    columns, 0, 65535);
    visitor.choice({"row_source", "",
                    "Row of a return: automatic = ring field, else ring order of the input, else "
                    "elevation; elevation = nearest beam; equation = evenly spaced rows.",
                    "paper Eq. 1, spec 1.4"},
                   rowSource, {"automatic", "elevation", "equation"});
  }
};

}  // namespace toss
