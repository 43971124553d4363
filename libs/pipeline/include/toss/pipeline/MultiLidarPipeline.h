// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/pipeline/Pipeline.h>

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace toss {

/// The method for the scans of one or several LiDARs on one robot: a Pipeline for each, with its
/// own beams, options and traces, and one static map of all. With a single LiDAR it is its
/// Pipeline.
class MultiLidarPipeline {
 public:
  /// `tiles`: see Pipeline.
  explicit MultiLidarPipeline(TileStore* tiles = nullptr) : tiles_(tiles) {}

  /// Adds the LiDAR whose scans carry that label; to be called before the first scan of it comes.
  /// The static map has the options (section map) of the LiDAR that was added first. Throws
  /// UserError for options out of range, std::logic_error for a label that was added before.
  void add(const std::string& label, PipelineOptions options, const SensorModel& sensor);
  bool has(const std::string& label) const { return lidars_.count(label) > 0; }

  /// Takes the next scan, later than the one before of the same LiDAR; scans of different LiDARs
  /// may come in any order. Returns its live labels, valid until the next call. Throws
  /// std::logic_error for a label that was not added, unless there is one LiDAR only.
  const ScanLabels& process(const PosedScan& scan);
  /// The same in two steps: see Pipeline.
  void segment(const PosedScan& scan, FirstStages& result);
  const ScanLabels& process(const PosedScan& scan, FirstStages& first);
  /// See Pipeline; for the LiDARs that were added before.
  void skipLiveLabels();
  /// Of the scan that process() took last: see Pipeline.
  const SegmentedScan& segmentedScan() const { return last_->pipeline->segmentedScan(); }
  const std::vector<std::pair<std::string, double>>& stageTimes() const {
    return last_->pipeline->stageTimes();
  }

  /// Scans of all LiDARs whose labels have become final since the last call, in order of their
  /// coming.
  std::vector<ScanLabels> takeSettled();
  /// Settles all scans that are left. Nothing may be processed after it.
  void finish();
  /// The same in steps: see Pipeline. To be called when takeSettled() has given what it has.
  void decideRest();
  bool settleNext(ScanLabels& labels);

  /// The map of all LiDARs: see Pipeline.
  std::vector<MapPoint> staticMap() const;
  void visitStaticMap(const std::function<void(const MapPoint&)>& visit) const;
  Eigen::Vector3d mapOffset() const;
  std::vector<MapPoint> pendingMap() const;

 private:
  struct Lidar {
    std::unique_ptr<Pipeline> pipeline;
    /// Final labels that wait for earlier scans of other LiDARs.
    std::deque<ScanLabels> settled;
    /// Time of the last scan [s]; scans whose labels are not final.
    double lastTime = 0.0;
    std::uint64_t open = 0;
  };
  /// Throws std::logic_error for a label that was not added, unless there is one LiDAR only.
  Lidar& lidarOf(const PosedScan& scan);
  void gather(Lidar& lidar);
  void settleSilent(double now);
  const Pipeline* any() const;

  TileStore* tiles_;
  MappingOptions mapping_;
  /// By label; the order does not show in results.
  std::map<std::string, Lidar> lidars_;
  /// The LiDAR of each scan whose final labels have not been taken, in order of their coming.
  std::deque<Lidar*> order_;
  Lidar* last_ = nullptr;
  FirstStages first_;
};

}  // namespace toss
