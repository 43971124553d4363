// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/tracking/KalmanFilter.h>
#include <toss/tracking/MotionEvidence.h>
#include <toss/tracking/Track.h>

namespace toss {

/// A trace with everything that its next update needs.
struct TrackState {
  Track track;
  KalmanFilter filter;
  MotionEvidence evidence;
  /// Its second detection came through the newborn gate: the next scan has to confirm its speed.
  bool awaitsConfirmation = false;
};

}  // namespace toss
