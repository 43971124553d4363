// SPDX-License-Identifier: BSD-3-Clause
#include "FlipWatch.h"

#include <algorithm>

namespace toss {

std::vector<LiveTrace> FlipWatch::update(const ScanLabels& labels) {
  constexpr double kShownFor = 1.0;
  std::vector<LiveTrace> traces;
  for (const TrackSample& sample : labels.tracks) {
    const auto [entry, isNew] = known_.try_emplace(sample.track);
    Known& known = entry->second;
    if (!isNew && known.moving != sample.moving) {
      known.flipTime = labels.time;
      ++flips_;
    }
    known.moving = sample.moving;
    known.lastTime = labels.time;
    known.path.push_back(sample.box.center);
    if (sample.updated)
      traces.push_back({sample, labels.time - known.flipTime < kShownFor, known.path});
  }
  std::stable_partition(traces.begin(), traces.end(),
                        [](const LiveTrace& trace) { return trace.sample.moving; });
  forgetOld(labels.time);
  return traces;
}

void FlipWatch::forgetOld(double now) {
  constexpr double kKept = 10.0;
  for (auto entry = known_.begin(); entry != known_.end();)
    entry = now - entry->second.lastTime > kKept ? known_.erase(entry) : std::next(entry);
}

}  // namespace toss
