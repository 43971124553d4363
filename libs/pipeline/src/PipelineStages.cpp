// SPDX-License-Identifier: BSD-3-Clause
#include "PipelineStages.h"

#include <toss/mapping/MapOffset.h>
#include <toss/tracking/BoundingBoxes.h>
#include <toss/tracking/Occlusion.h>

#include <algorithm>
#include <utility>

#include "MapCommit.h"
#include "ScanLabeling.h"

namespace toss {
namespace {

/// Whether an object goes so fast that most views meet its place without it. Of people that is
/// never sure: others come to where they were. What slides along with the sensor is longer.
bool leavesItsPlace(const TrackSample* sample) {
  if (sample == nullptr) return false;
  constexpr double kSoon = 1.5, kShortest = 2.5;
  const double length = std::max(sample->box.length, sample->box.width);
  return length >= kShortest && sample->velocity.head<2>().norm() * kSoon > length;
}

}  // namespace

Pipeline::Implementation::Implementation(const PipelineOptions& o, const SensorModel& sensor,
                                         std::shared_ptr<SharedMap> sharedMap)
    : options(o),
      segmenter(o.projection, o.ground, o.objects, sensor),
      tracker(o.tracking, o.motion, sharedMap->lastTrack),
      thinning(o.visibility.cellSize, o.visibility.maxCells, o.boxes.maxClearance),
      witness(o.visibility),
      voting(o.voting),
      traces(o.decision, o.visibility.enabled),
      judge(options.decision, voting, traces),
      hindsightClaims(o.decision, o.mapping, traces),
      liveClaims(o.decision, traces),
      shared(std::move(sharedMap)) {
  for (const Options* section : options.sections()) section->check();
  shared->pipelines.push_back(this);
}

Pipeline::Implementation::~Implementation() {
  std::vector<const Implementation*>& all = shared->pipelines;
  all.erase(std::remove(all.begin(), all.end(), this), all.end());
}

void Pipeline::Implementation::take(FirstStages& taken) {
  std::swap(segmented, taken.segmented);
  clock.restart();
  clock.book("projection", taken.times.projection);
  clock.book("ground", taken.times.ground);
  clock.book("objects", taken.times.objects);
}

void Pipeline::Implementation::track(const PosedScan& scan) {
  groundMemory.add(scan.time, scan.mapFromSensor.translation(),
                   segmented.segmentation.nearbyGround);
  detectInstances(segmented.level, segmented.segmentation, scan.mapFromSensor.translation(),
                  options.boxes, detections);
  measureOcclusion(segmented.image, segmented.segmentation, detections);
  clock.lap("boxes");
  tracker.update(scan.time, detections);
  for (const Track& each : tracker.tracks()) {
    traces.setMotion(each.id, each.motion);
    if (each.updated()) traces.addSighting(each.id);
  }
  clock.lap("tracking");
  records.push_back(builder.build(scan, segmented, detections, tracker));
  clock.lap("claims");
}

void Pipeline::Implementation::askViews(const PosedScan& scan) {
  pastEvidence.clear();
  if (options.visibility.enabled) {
    EvidenceCells cells;
    thinning.thin(segmented.level, segmented.segmentation, cells);
    witness.add(scan.time, segmented.image, scan.points, scan.mapFromSensor, std::move(cells));
    if (liveLabels) takePastEvidence();
  }
  builder.takeLevel(segmented.level, records.back());
  clock.lap("visibility");
}

void Pipeline::Implementation::takePastEvidence() {
  pastEvidence = sumByInstance(witness.latest(), segmented.segmentation.instanceCount,
                               options.visibility.minFreeViews);
  for (std::size_t k = 1; k < pastEvidence.size(); ++k)
    if (const TrackId id = records.back().owners[k].track; id != 0)
      traces.addPast(id, pastEvidence[k]);
}

void Pipeline::Implementation::vote(const PosedScan& scan) {
  ScanRecord& record = records.back();
  setFinalClasses(record, false);
  const BoxId firstBox = voting.addScan(votingBoxes(detections, tracker, scanNumber++, scan.time));
  for (std::size_t d = 0; d < detections.size(); ++d) {
    Owner& owner = record.owners[static_cast<std::size_t>(detections[d].instance)];
    owner.box = firstBox + d;
    owner.votes = true;
  }
  clock.lap("voting");
}

void Pipeline::Implementation::labelLive() {
  if (liveLabels) {
    const ScanRecord& record = records.back();
    const std::vector<bool> moving = judge.live(record, pastEvidence);
    labelScan(
        record, moving, [&](TrackId id) { return isDynamic(traces.liveClass(id)); }, live);
    liveClaims.add(record, moving, live);
  }
  clock.lap("labels");
}

void Pipeline::Implementation::setFinalClasses(const ScanRecord& record, bool last) {
  for (const TrackSample& sample : record.tracks)
    voting.setTrackClass(sample.track, traces.finalClass(sample.track, last));
}

void Pipeline::Implementation::setLastClasses() {
  const std::vector<TrackSample> none;
  const std::vector<TrackSample>* before = &none;
  for (const ScanRecord& record : records) {
    // A trace that was alive in the scan before has its class.
    auto known = before->begin();
    for (const TrackSample& sample : record.tracks) {
      while (known != before->end() && known->track < sample.track) ++known;
      if (known == before->end() || known->track != sample.track)
        voting.setTrackClass(sample.track, traces.finalClass(sample.track, true));
    }
    before = &record.tracks;
  }
}

void Pipeline::Implementation::takeEvidence(EvidenceCells& cells, ScanRecord& record) {
  const auto instances =
      static_cast<std::int32_t>(std::count_if(record.owners.begin(), record.owners.end(),
                                              [](const Owner& owner) { return owner.instance; }));
  groundMemory.recall(record.sensorPosition, options.ground.extent, recalled);
  silenceFloating(recalled, static_cast<float>(options.boxes.maxClearance), cells);
  const std::vector<FreeSpaceSum> sums =
      sumByInstance(cells, instances, options.visibility.minFreeViews);
  for (std::size_t k = 1; k < sums.size(); ++k) {
    record.owners[k].evidence = sums[k];
    if (const TrackId track = record.owners[k].track; track != 0) {
      traces.addFinal(track, sums[k], leavesItsPlace(record.sampleOf(track)));
      voting.setTrackClass(track, traces.finalClass(track, false));
    }
  }
  judge.findLoneMovers(cells, record);
}

StaticMap& Pipeline::Implementation::mapFrom(const ScanRecord& record) {
  std::unique_ptr<StaticMap>& map = shared->map;
  if (!map) {
    map = makeStaticMap(options.mapping, record.sensorPosition, shared->tiles);
    shared->offset = toss::mapOffset(record.sensorPosition);
  }
  return *map;
}

void Pipeline::Implementation::commitComplete() {
  const auto commitNext = [&] {
    ScanRecord& record = records[committed];
    StaticMap& map = mapFrom(record);
    std::vector<bool> moving = judge.final(record, false);
    clock.lap("mapping");
    hindsightClaims.add(records, committed++, false, moving);
    clock.lap("claims");
    commitScan(options.mapping, moving, record, shared->nextLedger, map);
    builder.reuseReturns(record);
    map.leaveBehind(record.sensorPosition);
  };
  if (options.visibility.enabled) {
    for (EvidenceCells& cells : witness.takeComplete(false)) {
      takeEvidence(cells, records[committed]);
      commitNext();
    }
  } else {
    const double now = records.empty() ? 0.0 : records.back().time;
    while (committed < records.size() &&
           now - records[committed].time >= options.mapping.insertionDelay)
      commitNext();
  }
  clock.lap("mapping");
}

void Pipeline::Implementation::decideOwners(ScanRecord& record) {
  record.moving = judge.final(record, true);
  updateLedgers(record, record.moving, *shared->map);
}

void Pipeline::Implementation::decideResidue(ScanRecord& record) {
  releaseResidue(options.decision.residuePlace, record.moving, *shared->map, record);
  settleLedgers(record, *shared->map);
  ++decided;
}

void Pipeline::Implementation::settleFirst(ScanLabels& labels) {
  ScanRecord& record = records.front();
  labelScan(
      record, record.moving, [&](TrackId id) { return isDynamic(traces.finalClass(id, true)); },
      labels);
  for (const Owner& owner : record.owners)
    if (owner.votes) voting.release(owner.box);
  builder.reuseOwners(record);
  records.pop_front();
  --committed;
  --decided;
  forgetOld();
}

void Pipeline::Implementation::forgetOld() {
  if (records.empty()) return;
  // Traces that are not in the oldest scan left are newer than those in it, or over.
  const ScanRecord& oldest = records.front();
  if (!oldest.tracks.empty()) traces.forgetBelow(oldest.tracks.front().track);
  if (options.voting.horizon > 0.0) voting.forgetBefore(oldest.time);
}

void Pipeline::Implementation::settleDue() {
  const double horizon = options.voting.horizon;
  while (horizon > 0.0 && committed > 0 && records.back().time - records.front().time > horizon) {
    setFinalClasses(records.front(), true);
    decideOwners(records.front());
    decideResidue(records.front());
    settled.emplace_back();
    settleFirst(settled.back());
  }
  clock.lap("settling");
}

void Pipeline::Implementation::decideAll() {
  if (options.visibility.enabled) {
    auto record = records.begin() + static_cast<std::ptrdiff_t>(committed);
    for (EvidenceCells& cells : witness.takeComplete(true)) takeEvidence(cells, *record++);
  }
  setLastClasses();
  // Residue of the first asks for what the last leaves in the map.
  for (std::size_t i = 0; i < committed; ++i) decideOwners(records[i]);
  commitDecided();
  for (ScanRecord& record : records) decideResidue(record);
}

void Pipeline::Implementation::commitDecided() {
  if (committed == records.size()) return;
  StaticMap& map = mapFrom(records[committed]);
  map.addDecided(records.size() - committed, [&](std::size_t i) {
    ScanRecord& record = records[committed + i];
    record.moving = judge.final(record, true);
    hindsightClaims.add(records, committed + i, true, record.moving);
    return decidedScan(options.mapping, record.moving, map, record);
  });
  for (; committed < records.size(); ++committed) builder.reuseReturns(records[committed]);
}

}  // namespace toss
