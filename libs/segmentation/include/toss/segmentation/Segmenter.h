// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/PosedScan.h>
#include <toss/geometry/SensorModel.h>
#include <toss/segmentation/GroundSegmentation.h>
#include <toss/segmentation/ObjectSegmentation.h>
#include <toss/segmentation/RangeImageProjection.h>

namespace toss {

/// Everything that segmentation knows about one scan, index-aligned with its points.
struct SegmentedScan {
  RangeImage image;
  LevelPoints level;
  Segmentation segmentation;
};

/// Stages 1 to 3 of the method: projection, ground, objects (paper section "Traversable Ground and
/// Above-Ground Object Segmentation"). Keeps its buffers from scan to scan; one per thread.
class Segmenter {
 public:
  /// `sensor`: beam geometry of the scans. Throws UserError for options out of range.
  Segmenter(const ProjectionOptions& projection, const GroundOptions& ground,
            const ObjectOptions& objects, const SensorModel& sensor);

  /// Segments one scan; `result`'s buffers are reused.
  void segment(const PosedScan& scan, SegmentedScan& result);

  /// Wall time of each stage of the last call [ms].
  struct StageTimes {
    double projection = 0.0, ground = 0.0, objects = 0.0;
  };
  const StageTimes& times() const { return times_; }

 private:
  RangeImageProjection projection_;
  GroundSegmentation ground_;
  ObjectSegmentation objects_;
  StageTimes times_;
};

}  // namespace toss
