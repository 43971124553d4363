// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <toss/rawlog/LabelFile.h>
#include <toss/rawlog/ScanSource.h>
#include <toss/segmentation/Segmenter.h>
#include <toss/tracking/BoundingBoxes.h>
#include <toss/tracking/Occlusion.h>
#include <toss/tracking/Tracker.h>

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <map>

namespace toss {
namespace {

std::filesystem::path realSequence() {
  const char* const given = std::getenv("TOSS_TEST_DATA");
  return std::filesystem::path(given ? given : "../shared/data") / "kitti-tracking-0000";
}

/// Annotated returns of a trace over its life.
struct AnnotatedReturns {
  int moving = 0, standing = 0;
};

/// What tracking makes of the real sequence.
struct Outcome {
  std::map<TrackId, AnnotatedReturns> returns;
  std::map<TrackId, MotionClass> motion;
};

void countReturns(const Segmentation& segmentation, const std::vector<std::uint32_t>& labels,
                  const std::vector<TrackId>& tracks, Outcome& outcome) {
  for (std::size_t point = 0; point < labels.size(); ++point) {
    const std::int32_t instance = segmentation.instance[point];
    if (instance == 0 || label::semantic(labels[point]) == label::kInvalid) continue;
    AnnotatedReturns& returns = outcome.returns[tracks[static_cast<std::size_t>(instance) - 1]];
    ++(label::isMoving(labels[point]) ? returns.moving : returns.standing);
  }
}

Outcome trackRealSequence(int scans) {
  const auto source = openScans(realSequence(), InputOptions{});
  ProjectionOptions projection;
  projection.egoRadius = 2.7;
  Segmenter segmenter(projection, {}, {}, sensorByName("HDL-64E"));
  Tracker tracker(TrackingOptions{});
  PosedScan scan;
  SegmentedScan segmented;
  std::vector<Detection> detections;
  Outcome outcome;
  for (int i = 0; i < scans && source->next(scan); ++i) {
    segmenter.segment(scan, segmented);
    detectInstances(segmented.level, segmented.segmentation, scan.mapFromSensor.translation(), {},
                    detections);
    measureOcclusion(segmented.image, segmented.segmentation, detections);
    tracker.update(scan.time, detections);
    const auto labels =
        readLabels(labelPath(realSequence() / "labels", scan.index), scan.points.size());
    countReturns(segmented.segmentation, labels, tracker.trackOfDetection(), outcome);
    for (const Track& track : tracker.tracks()) outcome.motion[track.id] = track.motion;
  }
  return outcome;
}

TEST(TrackingOnRealScans, CallsTheMoversMovingAndHardlyAnythingElse) {
  if (!std::filesystem::is_directory(realSequence())) {
    GTEST_SKIP() << "no real data: set TOSS_TEST_DATA to its folder";
  }
  const Outcome outcome = trackRealSequence(100);
  double found = 0.0, wrong = 0.0, missed = 0.0;
  int movingTracks = 0, wrongTracks = 0;
  for (const auto& [id, returns] : outcome.returns) {
    const auto entry = outcome.motion.find(id);
    const bool moving = entry != outcome.motion.end() && isDynamic(entry->second);
    (moving ? found : missed) += returns.moving;
    if (moving) wrong += returns.standing;
    movingTracks += moving ? 1 : 0;
    wrongTracks += moving && returns.standing > returns.moving ? 1 : 0;
  }
  std::cout << "annotated traces called moving: " << movingTracks << ", of them standing "
            << wrongTracks << "; precision " << found / (found + wrong) << ", recall "
            << found / (found + missed) << " of returns\n";
  EXPECT_GE(found / (found + wrong), 0.95);
  EXPECT_GE(found / (found + missed), 0.95);
  EXPECT_LE(wrongTracks, 3);
}

}  // namespace
}  // namespace toss
