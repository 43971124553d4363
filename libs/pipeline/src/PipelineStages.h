// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/pipeline/Pipeline.h>
#include <toss/segmentation/GroundMemory.h>
#include <toss/tracking/Tracker.h>
#include <toss/visibility/CellThinning.h>
#include <toss/visibility/FreeSpaceWitness.h>
#include <toss/voting/DsVoting.h>

#include <deque>
#include <memory>
#include <vector>

#include "HindsightClaims.h"
#include "Judge.h"
#include "LiveClaims.h"
#include "RecordBuilder.h"
#include "SharedMap.h"
#include "StageClock.h"

namespace toss {

/// The stages of the method and what they hand to each other, for one run.
struct Pipeline::Implementation {
  Implementation(const PipelineOptions& options, const SensorModel& sensor,
                 std::shared_ptr<SharedMap> shared);
  ~Implementation();
  Implementation(const Implementation&) = delete;
  Implementation& operator=(const Implementation&) = delete;

  /// Takes what stages 1 to 3 have found, and books their times.
  void take(FirstStages& first);
  /// Stages 4 to 6: boxes, traces, and how the traces moved.
  void track(const PosedScan& scan);
  /// Views of other scans testify, as far as they have been taken (spec section 12).
  void askViews(const PosedScan& scan);
  /// What past views say about each instance, and about its trace.
  void takePastEvidence();
  /// Stage 7: the boxes vote and are voted on.
  void vote(const PosedScan& scan);
  /// The answer with no look-ahead.
  void labelLive();
  /// Stage 8: scans on which all views have testified enter the map.
  void commitComplete();
  /// Labels that nothing can change any more become final.
  void settleDue();
  /// Decides about all scans that are left. Those that are not in the map by then enter it last,
  /// for good: nothing of them has to be taken back.
  void decideAll();
  /// Makes the labels of the first scan, which is decided, and forgets it.
  void settleFirst(ScanLabels& labels);

  /// The map by present knowledge of all pipelines that share it; nullptr before there is one.
  const StaticMap* presentMap() const;
  /// Gives the ledgers of this pipeline's scans their present labels.
  void updateMap() const;
  /// The map that all pipelines share; it begins where the first scan of any of them was taken.
  StaticMap& mapFrom(const ScanRecord& record);
  void commitDecided();
  void takeEvidence(EvidenceCells& cells, ScanRecord& record);
  void setFinalClasses(const ScanRecord& record, bool last);
  /// The same for all scans that are left, when no more will be known.
  void setLastClasses();
  /// Says for good what of a scan moves, and what of it is in the map; then, when the map is as far
  /// as it can be, what its residue is.
  void decideOwners(ScanRecord& record);
  void decideResidue(ScanRecord& record);
  void forgetOld();

  PipelineOptions options;
  Segmenter segmenter;
  Tracker tracker;
  CellThinning thinning;
  FreeSpaceWitness witness;
  DsVoting voting;
  TraceBook traces;
  Judge judge;
  HindsightClaims hindsightClaims;
  LiveClaims liveClaims;
  RecordBuilder builder;
  std::shared_ptr<SharedMap> shared;

  /// Of the present scan, and of the one before for its buffers.
  SegmentedScan segmented;
  FirstStages first;
  /// Ground that scans so far have known, and what is known of it around one of them.
  GroundMemory groundMemory;
  NearbyGround recalled;
  std::vector<Detection> detections;
  std::vector<FreeSpaceSum> pastEvidence;
  std::int64_t scanNumber = 0;
  /// Scans whose labels are not final, in order of time; the first `committed` are in the map, and
  /// of these the first `decided` only wait for their labels to be made.
  std::deque<ScanRecord> records;
  std::size_t committed = 0, decided = 0;
  std::vector<ScanLabels> settled;
  ScanLabels live;
  /// Whether live labels are wanted.
  bool liveLabels = true;
  StageClock clock;
};

}  // namespace toss
