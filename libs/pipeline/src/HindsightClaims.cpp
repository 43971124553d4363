// SPDX-License-Identifier: BSD-3-Clause
#include "HindsightClaims.h"

namespace toss {
namespace {

/// Stretch of a trace's path by which it is followed back, and what is too short for that [s].
constexpr double kPath = 1.0, kShortestPath = 0.4;
/// Below this [m/s] a trace has no way to follow.
constexpr double kSlowest = 0.1;
constexpr double kTimeTolerance = 1e-3;

/// Mean velocity of a trace over the first stretch of its path that is long enough, zero where
/// there is none.
Eigen::Vector3d firstVelocity(const std::deque<ScanRecord>& records, std::size_t birth,
                              const TrackSample& first) {
  const double start = records[birth].time;
  std::size_t end = birth;
  while (end + 1 < records.size() && records[end].time < start + kPath - kTimeTolerance) ++end;
  for (; records[end].time > start + kShortestPath - kTimeTolerance; --end) {
    if (const TrackSample* sample = records[end].sampleOf(first.track))
      return (sample->box.center - first.box.center) / (records[end].time - start);
  }
  return Eigen::Vector3d::Zero();
}

/// What seemed to move when the scan came in stood on the ground there. What came to move later, or
/// was missed and is only predicted, may not have: the ground around it is that of others.
bool seemedToMove(const TrackSample& sample) {
  constexpr double kStanding = 0.2;
  return sample.moving || (sample.updated && sample.velocity.head<2>().norm() > kStanding);
}

}  // namespace

HindsightClaims::HindsightClaims(const DecisionOptions& options, const MappingOptions& mapping,
                                 const TraceBook& traces)
    : claiming_(options.claims),
      claimingGround_(mapping.voxelSize > 0.0),
      birthTime_(options.hindsightTime),
      traces_(traces),
      finder_(options.residueMargin) {}

void HindsightClaims::add(Records& records, std::size_t index, bool last,
                          std::vector<bool>& moving) {
  if (!claiming_) return;
  findClaimants(records, index, last);
  ScanRecord& record = records[index];
  owners_.start(claimants_.size(), record.owners.size());
  for (const Claim& claim : finder_.find(claimants_, record, moving)) addClaim(claim, record);
  for (std::size_t o = moving.size(); o < record.owners.size(); ++o)
    moving.push_back(isDynamic(traces_.finalClass(record.owners[o].track, last)));
}

void HindsightClaims::addClaim(const Claim& claim, ScanRecord& record) {
  ScanRecord::OwnerIndex& owner = record.owner[static_cast<std::size_t>(claim.point)];
  const std::int32_t host = owner;
  const auto [number, isNew] = owners_.ownerOf(claim.claimant, host);
  if (isNew)
    record.owners.push_back(
        Owner::ofClaim(claimants_[static_cast<std::size_t>(claim.claimant)].track, host));
  owner = ScanRecord::ownerIndex(number);
  record.residue.push_back(claim.point);
}

void HindsightClaims::findClaimants(const Records& records, std::size_t index, bool last) {
  claimants_.clear();
  const ScanRecord& scan = records[index];
  for (const TrackSample& sample : scan.tracks)
    if (traces_.mayClaim(sample.track, last))
      claimants_.push_back({sample.track, sample.box, claimingGround_ && seemedToMove(sample)});
  for (std::size_t birth = index + 1; birth < records.size(); ++birth) {
    if (records[birth].time > scan.time + birthTime_ + kTimeTolerance) break;
    followBack(records, birth, scan.time, last);
  }
}

void HindsightClaims::followBack(const Records& records, std::size_t birth, double time,
                                 bool last) {
  const ScanRecord& record = records[birth];
  for (auto first = record.samplesFrom(record.firstNewTrack); first != record.tracks.end();
       ++first) {
    if (!traces_.mayClaim(first->track, last)) continue;
    const Eigen::Vector3d velocity = firstVelocity(records, birth, *first);
    if (velocity.head<2>().norm() < kSlowest) continue;
    Box before = first->box;
    before.center -= (record.time - time) * velocity;
    claimants_.push_back({first->track, before});
  }
}

}  // namespace toss
