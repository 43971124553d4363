// SPDX-License-Identifier: BSD-3-Clause
#include <toss/mapping/MappingOptions.h>

namespace toss {

void MappingOptions::visit(OptionVisitor& visitor) {
  visitor.real(
      {"voxel_size", "m", "Edge of a voxel of the map; 0 keeps every return as a point of its own",
       "spec 8.2"},
      voxelSize, 0.0, 10.0);
  visitor.integer(
      {"cap", "",
       "Returns of one scan and instance that count in one voxel; smaller gives what is "
       "seen for long less weight",
       "spec 8.2"},
      cap, 1, 65535);
  visitor.integer({"min_points", "", "Returns a voxel needs to be in the finished map", "spec 8.2"},
                  minPoints, 1, 1000);
  visitor.flag(
      {"keep_below_ground", "", "Whether returns under the ground (mirrors) are kept", "spec 8.1"},
      keepBelowGround);
  visitor.choice({"far_points", "", "What becomes of returns out of range", "spec 1.1"}, farPoints,
                 {"keep_static", "drop"});
  visitor.real(
      {"insertion_delay", "s",
       "Time between a scan and the entry of its boxes; the final map does not depend on it",
       "spec 7.5"},
      insertionDelay, 0.0, 60.0);
  visitor.real({"tile_size", "m",
                "Least edge of the parts of the map that wait on disk while they are far away; 0 "
                "keeps all in memory; the map is the same",
                "memory of long logs"},
               tileSize, 0.0, 10000.0);
  visitor.real({"tiles_keep_radius", "m",
                "Parts of the map nearer than this stay in memory; the map is the same",
                "ranges of sensors, and ways within voting.horizon"},
               tilesKeepRadius, 0.0, 100000.0);
}

}  // namespace toss
