// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/PosedScan.h>
#include <toss/segmentation/Segmenter.h>
#include <toss/tracking/Tracker.h>

#include "ScanRecord.h"

namespace toss {

/// Turns what segmentation and tracking found in a scan into its record.
class RecordBuilder {
 public:
  /// All but the coordinates.
  ScanRecord build(const PosedScan& scan, const SegmentedScan& segmented,
                   const std::vector<Detection>& detections, const Tracker& tracker);

  /// Gives the record of a scan its coordinates; `level` gets the memory of an earlier scan's.
  void takeLevel(LevelPoints& level, ScanRecord& record);
  /// Takes the memory of the returns for a later scan: `record` is in the map and needs its
  /// coordinates and intensities no more.
  void reuseReturns(ScanRecord& record);
  /// The same for the owners, classes and residue of a settled scan.
  void reuseOwners(ScanRecord& record);

 private:
  void addInstances(const std::vector<Detection>& detections, const Tracker& tracker,
                    ScanRecord& record) const;
  /// Makes every return that of its instance.
  void addOwnInstances(const std::vector<std::int32_t>& instance, ScanRecord& record);
  /// The newest trace so far.
  TrackId lastTrack_ = 0;
  /// Memory of scans that need it no more.
  std::vector<LevelPoints> spareLevels_;
  std::vector<std::vector<float>> spareIntensities_;
  std::vector<std::vector<PointClass>> spareClasses_;
  std::vector<std::vector<ScanRecord::OwnerIndex>> spareOwners_;
  std::vector<std::vector<std::int32_t>> spareResidues_;
  std::vector<std::vector<VoxelKey>> sparePlaces_;
};

/// The boxes of a scan as DS-Voting takes them, in the order of their owners, which learn their
/// number: that of the first box is `firstBox`.
std::vector<VotingBox> votingBoxes(const std::vector<Detection>& detections, const Tracker& tracker,
                                   std::int64_t scanNumber, double time);

}  // namespace toss
