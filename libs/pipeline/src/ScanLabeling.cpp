// SPDX-License-Identifier: BSD-3-Clause
#include "ScanLabeling.h"

namespace toss {

void labelScan(const ScanRecord& record, const std::vector<bool>& movingOwners,
               const std::function<bool(TrackId)>& isMovingTrack, ScanLabels& labels) {
  const std::size_t n = record.owner.size();
  labels.scan = record.scan;
  labels.time = record.time;
  labels.state.resize(n);
  labels.track.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const auto owner = static_cast<std::size_t>(record.owner[i]);
    // Ground that no moving trace claims is nobody's.
    const bool moving = movingOwners[owner] || record.loneMover[i];
    const bool owned = record.owners[owner].instance || moving;
    labels.state[i] = record.pointClass[i] == PointClass::Invalid ? PointState::Invalid
                      : moving                                    ? PointState::Moving
                                                                  : PointState::Static;
    labels.track[i] = owned ? static_cast<std::uint32_t>(record.owners[owner].track) : 0;
  }
  labels.tracks = record.tracks;
  for (TrackSample& sample : labels.tracks) sample.moving = isMovingTrack(sample.track);
}

}  // namespace toss
