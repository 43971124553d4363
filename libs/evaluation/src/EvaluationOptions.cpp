// SPDX-License-Identifier: BSD-3-Clause
#include <toss/evaluation/EvaluationOptions.h>

#include <limits>

namespace toss {
namespace {

constexpr int kMost = std::numeric_limits<int>::max();

}  // namespace

void EvaluationOptions::visit(OptionVisitor& v) {
  v.real({"voxel_size", "m", "edge of the voxels in which PR and RR are counted", "spec 9.3"},
         voxelSize, 0.01, 5.0);
  v.real({"ego_radius", "m", "points horizontally nearer than this are in neither map", "spec 9.3"},
         egoRadius, 0.0, 100.0);
  v.choice({"unlabelled", "",
            "points that are not annotated: auto ignores them where they are the majority",
            "spec ambiguity 45"},
           unlabelled, {"auto", "static", "ignore"});
  v.flag({"omit_truck_class", "", "count moving trucks (258) as static, as two public scripts do",
          "spec ambiguity 44"},
         omitTruckClass);
  v.integer({"from", "", "index of the first scan that is scored", "spec 9.1"}, from, 0, kMost);
  v.integer({"to", "", "index of the last scan that is scored, -1 = the last one", "spec 9.1"}, to,
            -1, kMost);
  v.integer({"stride", "", "every how manieth scan is scored; ERASOR: 2", "spec ambiguity 42"},
            stride, 1, kMost);
  v.real({"removal_distance", "m", "SA, DA: farther than this from all kept points is removed",
          "spec 9.4"},
         removalDistance, 0.001, 1.0);
  v.real({"removal_range", "m", "SA, DA: points farther from the sensor are left out", "spec 9.4"},
         removalRange, 0.0, 1000.0);
  v.real({"removal_ego_range", "m", "SA, DA: unlabelled points nearer than this count as moving",
          "spec 9.4"},
         removalEgoRange, 0.0, 100.0);
  v.flag({"bounds", "", "compute what an oracle would reach on the run's segmentation", "spec 11"},
         bounds);
  v.integer({"tracking_min_returns", "",
             "objects and false tracks of fewer returns in a scan do not count", "spec 9.4"},
            trackingMinReturns, 1, kMost);
  v.real(
      {"tracking_overlap", "", "least overlap of a track's returns with an object's", "CLEAR MOT"},
      trackingOverlap, 0.01, 1.0);
  v.choice({"box_match", "", "how reported boxes are held against true ones", "spec 9.4"}, boxMatch,
           {"distance", "overlap"});
  v.real({"box_distance", "m", "largest distance of matching box centres", "nuScenes"}, boxDistance,
         0.01, 100.0);
  v.real({"box_overlap", "", "least overlap of matching boxes", "AB3DMOT"}, boxOverlap, 0.01, 1.0);
}

}  // namespace toss
