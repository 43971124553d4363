// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/PosedScan.h>
#include <toss/geometry/SensorModel.h>
#include <toss/mapping/VoxelMap.h>
#include <toss/pipeline/PipelineOptions.h>
#include <toss/pipeline/ScanLabels.h>
#include <toss/segmentation/Segmenter.h>

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace toss {

/// What stages 1 to 3 have made of a scan, and how long they took.
struct FirstStages {
  SegmentedScan segmented;
  Segmenter::StageTimes times;
};

/// TOSS itself: posed scans in, labels and a static map out. Each scan gets a live answer at once,
/// and its final one when nothing that comes later can change it within the horizon.
class Pipeline {
 public:
  /// Throws UserError for options out of range. `sensor`: beam geometry of all scans.
  /// `tiles`: outlives the pipeline and takes parts of the map that are far away; nullptr = the map
  /// stays in memory.
  Pipeline(const PipelineOptions& options, const SensorModel& sensor, TileStore* tiles = nullptr);
  /// For another LiDAR of the same robot: its returns go into the static map of `other`, which is
  /// that of both from now on, and its traces have numbers that those of `other` do not have. Both
  /// belong to one thread at a time.
  Pipeline(const PipelineOptions& options, const SensorModel& sensor, const Pipeline& other);
  ~Pipeline();

  /// Takes the next scan, later than the one before. Returns its live labels: decided with no
  /// look-ahead; valid until the next call.
  const ScanLabels& process(const PosedScan& scan);
  /// The same in two steps. segment() does what needs no other scan and may run in another thread
  /// than everything else, one call at a time, while earlier scans are processed; `result`'s
  /// buffers are reused. process() takes the segmentation out of `first` and leaves the buffers of
  /// the scan before in its place.
  void segment(const PosedScan& scan, FirstStages& result);
  const ScanLabels& process(const PosedScan& scan, FirstStages& first);
  /// For who wants final labels and the map alone: live labels, which take what past views say
  /// about every trace, are not made; process() returns empty ones from now on. Not to be called
  /// after the first scan, as traces would lack what was not asked; pendingMap() knows motion only.
  void skipLiveLabels();
  /// Segmentation of the scan that process() took last, for viewers; its level coordinates hold
  /// no meaning, as those of the scan have become part of what is kept of it.
  const SegmentedScan& segmentedScan() const;

  /// Scans whose labels have become final since the last call, in order of their coming.
  std::vector<ScanLabels> takeSettled();
  /// Settles all scans that are left, without what later ones could tell about them: for the end
  /// of the log, or of a part after which no scan comes for long.
  void finish();
  /// The same in steps, for who writes labels while the next are made. decideRest() comes to all
  /// decisions, after which the map is final and may be visited by another thread than the one that
  /// calls settleNext(): that replaces `labels` by those of the next scan that is left, in order of
  /// coming, until it returns false. No scan may come before that.
  void decideRest();
  bool settleNext(ScanLabels& labels);

  /// The static map by present knowledge: voxel centroids, or every kept return where
  /// map.voxel_size is 0. Map frame [m].
  std::vector<MapPoint> staticMap() const;
  /// The same point by point and without keeping it in memory, less mapOffset().
  void visitStaticMap(const std::function<void(const MapPoint&)>& visit) const;
  /// What has to be added to those points [m, map frame]: zero unless the log lies far from the
  /// origin of its frame.
  Eigen::Vector3d mapOffset() const;
  /// The scans that are not in staticMap() yet, the last few seconds: their returns without those
  /// of traces that move by what is known now, made into a map of their own. Nothing after
  /// finish().
  std::vector<MapPoint> pendingMap() const;

  /// Wall time of each stage in the last process() [ms], in order of the stages:
  /// projection, ground, objects, boxes, tracking (spec section 5, to the class of each trace),
  /// claims (what predicted boxes take beyond their instances), visibility, voting, labels (live
  /// ones), mapping, settling.
  const std::vector<std::pair<std::string, double>>& stageTimes() const;

  /// Parts of a pipeline.
  struct Implementation;

 private:
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace toss
