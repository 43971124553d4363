// SPDX-License-Identifier: BSD-3-Clause
#include "RecordBuilder.h"

#include <algorithm>
#include <utility>

namespace toss {
namespace {

const Track* findTrack(const std::vector<Track>& tracks, TrackId id) {
  const auto found = std::lower_bound(tracks.begin(), tracks.end(), id,
                                      [](const Track& t, TrackId wanted) { return t.id < wanted; });
  return found != tracks.end() && found->id == id ? &*found : nullptr;
}

/// Whether a trace moves, or may turn out to have moved when more of it has been seen.
bool mayMove(const Track& track) {
  constexpr double kSlowest = 0.2;
  return isDynamic(track.motion) || (track.confirmed && track.speed() > kSlowest);
}

/// Memory fresh from the system costs more than what is written into it.
template <typename T>
void copyIntoSpare(const T& source, std::vector<T>& spares, T& target) {
  if (!spares.empty()) {
    target = std::move(spares.back());
    spares.pop_back();
  }
  target = source;
}

}  // namespace

void RecordBuilder::addInstances(const std::vector<Detection>& detections, const Tracker& tracker,
                                 ScanRecord& record) const {
  for (std::size_t d = 0; d < detections.size(); ++d) {
    Owner& owner = record.owners[static_cast<std::size_t>(detections[d].instance)];
    owner.instance = true;
    owner.track = tracker.trackOfDetection()[d];
  }
}

void RecordBuilder::addClaims(const SegmentedScan& segmented,
                              const std::vector<Detection>& detections, const Tracker& tracker,
                              ScanRecord& record) {
  std::vector<bool> standing(record.owners.size());
  for (std::size_t k = 1; k < standing.size(); ++k) {
    const Track* track = findTrack(tracker.tracks(), record.owners[k].track);
    standing[k] = track == nullptr || !isDynamic(track->motion);
  }
  std::vector<BoxClaims::Claimant> claimants;
  std::vector<GroundContact::Body> bodies;
  for (const Track& track : tracker.tracks()) {
    if (track.updated())
      bodies.push_back({detections[static_cast<std::size_t>(track.detection)].instance,
                        static_cast<std::int32_t>(claimants.size())});
    // What was seen tells the extent of this scan better than the smoothed estimate.
    claimants.push_back(
        track.updated()
            ? BoxClaims::Claimant{detections[static_cast<std::size_t>(track.detection)].box, false}
            : BoxClaims::Claimant{track.box, mayMove(track)});
    Owner owner;
    owner.track = track.id;
    record.owners.push_back(owner);
  }
  claims_.find(segmented.level, segmented.segmentation, claimants, record.sensorPosition, standing,
               foundClaims_);
  foundContacts_.clear();
  contact_.find(segmented.level, segmented.segmentation, bodies, foundContacts_);
  const std::int32_t firstClaim = segmented.segmentation.instanceCount + 1;
  for (const auto* found : {&foundContacts_, &foundClaims_})
    for (const BoxClaims::Claim& claim : *found)
      record.owner[static_cast<std::size_t>(claim.point)] = firstClaim + claim.claimant;
  findCompanions(detections, tracker, record);
}

void RecordBuilder::findCompanions(const std::vector<Detection>& detections, const Tracker& tracker,
                                   ScanRecord& record) const {
  const std::vector<Track>& tracks = tracker.tracks();
  for (std::size_t d = 0; d < detections.size(); ++d) {
    const Detection& detection = detections[d];
    if (detection.pointCount >= fragmentPoints_) continue;
    Owner& owner = record.owners[static_cast<std::size_t>(detection.instance)];
    const Track* own = findTrack(tracks, owner.track);
    const auto except = own != nullptr ? static_cast<std::int32_t>(own - tracks.data()) : -1;
    const Eigen::Vector3f center = (detection.box.center - record.sensorPosition).cast<float>();
    const std::int32_t around = claims_.boxAround(center, except);
    if (around < 0) continue;
    const Track& companion = tracks[static_cast<std::size_t>(around)];
    const bool larger =
        !companion.updated() ||
        detections[static_cast<std::size_t>(companion.detection)].pointCount > detection.pointCount;
    if (larger) owner.companion = companion.id;
  }
}

void RecordBuilder::reuseReturns(ScanRecord& record) {
  spareLevels_.push_back(std::exchange(record.level, {}));
  spareIntensities_.push_back(std::exchange(record.intensity, {}));
}

void RecordBuilder::reuseOwners(ScanRecord& record) {
  spareClasses_.push_back(std::exchange(record.pointClass, {}));
  spareOwners_.push_back(std::exchange(record.owner, {}));
}

ScanRecord RecordBuilder::build(const PosedScan& scan, const SegmentedScan& segmented,
                                const std::vector<Detection>& detections, const Tracker& tracker) {
  ScanRecord record;
  record.scan = scan.index;
  record.time = scan.time;
  record.sensorPosition = scan.mapFromSensor.translation();
  copyIntoSpare(segmented.segmentation.pointClass, spareClasses_, record.pointClass);
  copyIntoSpare(segmented.segmentation.instance, spareOwners_, record.owner);
  copyIntoSpare(segmented.level, spareLevels_, record.level);
  copyIntoSpare(scan.points.intensity, spareIntensities_, record.intensity);
  record.owners.resize(static_cast<std::size_t>(segmented.segmentation.instanceCount) + 1);
  addInstances(detections, tracker, record);
  if (claiming_) addClaims(segmented, detections, tracker, record);
  for (const Track& track : tracker.tracks())
    record.tracks.push_back(
        {track.id, isDynamic(track.motion), track.updated(), track.box, track.velocity});
  return record;
}

std::vector<VotingBox> votingBoxes(const std::vector<Detection>& detections, const Tracker& tracker,
                                   std::int64_t scanNumber, double time) {
  std::vector<VotingBox> boxes;
  for (std::size_t d = 0; d < detections.size(); ++d) {
    const Box& box = detections[d].box;
    const Track* track = findTrack(tracker.tracks(), tracker.trackOfDetection()[d]);
    VotingBox vote;
    vote.scan = scanNumber;
    vote.time = time;
    vote.center = box.center;
    vote.volume = box.volume();
    vote.extent = std::max(box.length, box.width);
    if (track != nullptr) vote.track = track->id, vote.speed = track->speed();
    boxes.push_back(vote);
  }
  return boxes;
}

}  // namespace toss
