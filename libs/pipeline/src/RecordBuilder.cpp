// SPDX-License-Identifier: BSD-3-Clause
#include "RecordBuilder.h"

#include <algorithm>
#include <utility>

namespace toss {
namespace {

/// Index in tracker.tracks() of the trace of each detection, -1 = none.
std::vector<std::int32_t> tracesOf(const std::vector<Detection>& detections,
                                   const Tracker& tracker) {
  std::vector<std::int32_t> traces(detections.size(), -1);
  for (std::size_t t = 0; t < tracker.tracks().size(); ++t)
    if (const Track& track = tracker.tracks()[t]; track.updated())
      traces[static_cast<std::size_t>(track.detection)] = static_cast<std::int32_t>(t);
  return traces;
}

/// Memory fresh from the system costs more than what is written into it.
template <typename T>
void takeSpare(std::vector<T>& spares, T& target) {
  if (spares.empty()) return;
  target = std::move(spares.back());
  spares.pop_back();
}

template <typename T>
void copyIntoSpare(const T& source, std::vector<T>& spares, T& target) {
  takeSpare(spares, target);
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

void RecordBuilder::addOwnInstances(const std::vector<std::int32_t>& instance, ScanRecord& record) {
  takeSpare(spareOwners_, record.owner);
  record.owner.resize(instance.size());
  std::transform(instance.begin(), instance.end(), record.owner.begin(), ScanRecord::ownerIndex);
}

void RecordBuilder::takeLevel(LevelPoints& level, ScanRecord& record) {
  takeSpare(spareLevels_, record.level);
  std::swap(level, record.level);
}

void RecordBuilder::reuseReturns(ScanRecord& record) {
  spareLevels_.push_back(std::exchange(record.level, {}));
  spareIntensities_.push_back(std::exchange(record.intensity, {}));
}

void RecordBuilder::reuseOwners(ScanRecord& record) {
  spareClasses_.push_back(std::exchange(record.pointClass, {}));
  spareOwners_.push_back(std::exchange(record.owner, {}));
  spareResidues_.push_back(std::exchange(record.residue, {}));
  sparePlaces_.push_back(std::exchange(record.residuePlace, {}));
}

ScanRecord RecordBuilder::build(const PosedScan& scan, const SegmentedScan& segmented,
                                const std::vector<Detection>& detections, const Tracker& tracker) {
  ScanRecord record;
  record.scan = scan.index;
  record.time = scan.time;
  record.sensorPosition = scan.mapFromSensor.translation();
  copyIntoSpare(segmented.segmentation.pointClass, spareClasses_, record.pointClass);
  addOwnInstances(segmented.segmentation.instance, record);
  copyIntoSpare(scan.points.intensity, spareIntensities_, record.intensity);
  takeSpare(spareResidues_, record.residue);
  takeSpare(sparePlaces_, record.residuePlace);
  record.residue.clear();
  const std::size_t instances = static_cast<std::size_t>(segmented.segmentation.instanceCount) + 1;
  record.owners.resize(instances);
  addInstances(detections, tracker, record);
  record.tracks.reserve(tracker.tracks().size());
  for (const Track& track : tracker.tracks())
    record.tracks.push_back(
        {track.id, isDynamic(track.motion), track.updated(), track.box, track.velocity});
  record.firstNewTrack = lastTrack_ + 1;
  if (!record.tracks.empty()) lastTrack_ = std::max(lastTrack_, record.tracks.back().track);
  return record;
}

std::vector<VotingBox> votingBoxes(const std::vector<Detection>& detections, const Tracker& tracker,
                                   std::int64_t scanNumber, double time) {
  const std::vector<std::int32_t> traces = tracesOf(detections, tracker);
  std::vector<VotingBox> boxes;
  boxes.reserve(detections.size());
  for (std::size_t d = 0; d < detections.size(); ++d) {
    const Box& box = detections[d].box;
    VotingBox vote;
    vote.scan = scanNumber;
    vote.time = time;
    vote.center = box.center;
    vote.volume = box.volume();
    vote.extent = std::max(box.length, box.width);
    if (traces[d] >= 0) {
      const Track& track = tracker.tracks()[static_cast<std::size_t>(traces[d])];
      vote.track = track.id, vote.speed = track.speed();
    }
    boxes.push_back(vote);
  }
  return boxes;
}

}  // namespace toss
