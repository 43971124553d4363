// SPDX-License-Identifier: BSD-3-Clause
#include <toss/tracking/TrackLifecycle.h>

#include <cmath>

namespace toss {

bool mayContinueTrack(const Detection& detection, const LifecycleOptions& options) {
  const Box& box = detection.box;
  return !detection.background && detection.pointCount >= options.minMatchPoints &&
         box.center.allFinite() && std::isfinite(box.yaw + box.length + box.width + box.height);
}

bool mayStartTrack(const Detection& detection, const LifecycleOptions& options) {
  return mayContinueTrack(detection, options) && detection.pointCount >= options.minBirthPoints;
}

bool hasEnded(const Track& track, const LifecycleOptions& options) {
  if (options.rule == LifeRule::AutoMos) return track.totalMisses >= options.maxMisses;
  return track.misses >= (isDynamic(track.motion) ? options.maxMissesMoving : options.maxMisses);
}

}  // namespace toss
