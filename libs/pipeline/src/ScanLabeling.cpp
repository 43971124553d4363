// SPDX-License-Identifier: BSD-3-Clause
#include "ScanLabeling.h"

namespace toss {
namespace {

/// What all valid returns of an owner get.
struct OwnerLabel {
  PointState state;
  std::uint32_t track;
};

/// Ground that no moving trace claims is nobody's.
OwnerLabel ownerLabel(const Owner& owner, bool moving) {
  const bool owned = owner.instance || moving;
  return {moving ? PointState::Moving : PointState::Static,
          owned ? static_cast<std::uint32_t>(owner.track) : 0};
}

/// The owner's trace, as far as the scan has a sample of it: those that are followed back to it
/// have none.
std::uint32_t trackInScan(const ScanRecord& record, const Owner& owner) {
  return record.sampleOf(owner.track) ? static_cast<std::uint32_t>(owner.track) : 0;
}

/// Who says what an owner's returns are: what is claimed is what it would be without the claim.
std::size_t namingOwner(const ScanRecord& record, std::size_t o) {
  const Owner& owner = record.owners[o];
  return owner.instance ? o : static_cast<std::size_t>(owner.host);
}

}  // namespace

void labelScan(const ScanRecord& record, const std::vector<bool>& movingOwners,
               const std::function<bool(TrackId)>& isMovingTrack, ScanLabels& labels) {
  const std::size_t n = record.owner.size();
  labels.scan = record.scan;
  labels.time = record.time;
  labels.state.resize(n);
  labels.track.resize(n);
  std::vector<OwnerLabel> labelOf;
  labelOf.reserve(record.owners.size());
  for (std::size_t o = 0; o < record.owners.size(); ++o) {
    const std::size_t naming = namingOwner(record, o);
    labelOf.push_back(ownerLabel(record.owners[naming], movingOwners[naming]));
  }
  for (std::size_t i = 0; i < n; ++i) {
    const OwnerLabel label = labelOf[static_cast<std::size_t>(record.owner[i])];
    const bool valid = record.pointClass[i] != PointClass::Invalid;
    labels.state[i] = valid ? label.state : PointState::Invalid;
    labels.track[i] = label.track;
  }
  for (const std::int32_t point : record.loneMovers) {
    const auto i = static_cast<std::size_t>(point);
    const Owner& owner = record.owners[static_cast<std::size_t>(record.owner[i])];
    labels.state[i] = PointState::Moving;
    labels.track[i] = trackInScan(record, owner);
  }
  labels.tracks = record.tracks;
  for (TrackSample& sample : labels.tracks) sample.moving = isMovingTrack(sample.track);
}

}  // namespace toss
