// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/tracking/Detection.h>
#include <toss/tracking/MotionOptions.h>
#include <toss/tracking/Track.h>
#include <toss/tracking/TrackingOptions.h>

#include <memory>
#include <vector>

namespace toss {

/// Multi-object tracking (paper section 3DMOT): constant-velocity Kalman filters, hierarchical
/// association, birth and death of traces, and the coarse motion class of each.
class Tracker {
 public:
  /// Throws UserError for options out of range. `lastId`: number of the trace that was started
  /// last, for trackers whose traces must not share numbers; nullptr = this one counts by itself,
  /// from 1.
  explicit Tracker(const TrackingOptions& tracking, const MotionOptions& motion = {},
                   std::shared_ptr<TrackId> lastId = nullptr);
  ~Tracker();

  /// Predicts all traces to `time` [s] (later than the last call's, else std::logic_error),
  /// associates `detections` with them, updates, starts and ends traces, and classifies their
  /// motion. The traces do not depend on the order of the detections.
  void update(double time, const std::vector<Detection>& detections);

  /// Trace of each detection of the last scan, 0 for background and for boxes with too few points,
  /// shape [detections].
  const std::vector<TrackId>& trackOfDetection() const;
  /// Traces that are alive, by ascending id, coasting ones included.
  const std::vector<Track>& tracks() const;
  /// Traces that ended with the last scan, by ascending id, in their last state.
  const std::vector<Track>& ended() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace toss
