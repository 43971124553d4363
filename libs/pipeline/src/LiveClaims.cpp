// SPDX-License-Identifier: BSD-3-Clause
#include "LiveClaims.h"

namespace toss {

const std::vector<Claim>& LiveClaims::find(const ScanRecord& record,
                                           const std::vector<bool>& moving) {
  claimants_.clear();
  for (const TrackSample& sample : record.tracks)
    if (claiming_ && isDynamic(traces_.liveClass(sample.track)))
      claimants_.push_back({sample.track, sample.box});
  return finder_.find(claimants_, record, moving);
}

void LiveClaims::add(const ScanRecord& record, const std::vector<bool>& moving,
                     ScanLabels& labels) {
  for (const Claim& claim : find(record, moving)) {
    const auto point = static_cast<std::size_t>(claim.point);
    const Claimant& claimant = claimants_[static_cast<std::size_t>(claim.claimant)];
    labels.state[point] = PointState::Moving;
    labels.track[point] = static_cast<std::uint32_t>(claimant.track);
  }
}

}  // namespace toss
