// SPDX-License-Identifier: BSD-3-Clause
#include <toss/odometry/OdometryOptions.h>

namespace toss {

void OdometryOptions::visit(OptionVisitor& visitor) {
  const char* paper = "KISS-ICP, section III";
  visitor.real(
      {"min_range", "m",
       "Returns nearer than this do not take part: those on the robot itself go with it.", "TOSS"},
      minRange, 0.0, 100.0);
  visitor.real({"max_range", "m",
                "Returns farther than this do not take part, and the local map reaches this far; "
                "larger values hold the pose better where little is near.",
                paper},
               maxRange, 1.0, 1000.0);
  visitor.real({"voxel_size", "m",
                "Edge of the voxels of the local map; smaller values are finer and slower; 0 takes "
                "a hundredth of max_range.",
                paper},
               voxelSize, 0.0, 10.0);
  visitor.integer({"points_per_voxel", "points",
                   "Most points of the local map in one voxel; more are finer and slower.", paper},
                  pointsPerVoxel, 1, 20);
  visitor.real({"initial_threshold", "m",
                "How far from its prediction the pose may be before any motion was seen; larger "
                "values bear a faster start.",
                paper},
               initialThreshold, 0.01, 100.0);
  visitor.real({"start_speed", "m/s",
                "Greatest speed that the sensor may have at the first scan; 0 where it stands, "
                "which saves a search.",
                "TOSS"},
               startSpeed, 0.0, 200.0);
  visitor.real(
      {"min_motion", "m",
       "Deviations from the prediction below this do not narrow the adaptive threshold.", paper},
      minMotion, 0.0, 10.0);
  visitor.integer(
      {"max_iterations", "",
       "Most iterations per scan; more take longer where the start was far off.", paper},
      maxIterations, 1, 1000);
  visitor.real({"convergence", "m, rad",
                "Steps smaller than this end the alignment; smaller values are slower.", paper},
               convergence, 1e-9, 0.1);
}

}  // namespace toss
