// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/pipeline/MultiLidarPipeline.h>
#include <toss/pipeline/ScanLabels.h>
#include <toss/rawlog/AtomicFile.h>
#include <toss/rawlog/AtomicFolder.h>
#include <toss/rawlog/FilteredRawlogWriter.h>
#include <toss/rawlog/PlyFile.h>
#include <toss/rawlog/TracksCsv.h>
#include <toss/render/MapContent.h>
#include <toss/render/PointSample.h>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "MapRun.h"

namespace toss {

/// Counts of a run, for summary.json.
struct RunCounts {
  std::uint64_t scans = 0, points = 0, invalid = 0, moving = 0, tracks = 0, movingTracks = 0,
                mapPoints = 0;
};

/// The files of a run, written as labels become final, under temporary names until finish().
class MapOutputs {
 public:
  /// Throws UserError where the output can not be written or holds what must not be replaced.
  MapOutputs(const MapRequest& request, const RenderOptions& render);

  /// Writes label files of a scan: live labels, what segmentation made of it (for the evaluator's
  /// bounds), and final labels. May be called from several threads, for scans in any order.
  void writeLive(const ScanLabels& labels) const;
  void writeInstances(std::uint64_t scan, const Segmentation& segmentation) const;
  void writeFinal(const ScanLabels& labels) const;
  /// Everything else of a scan whose labels are final, in order of the scans.
  /// `offset` [m]: taken off all coordinates of maps and pictures, the same for all scans.
  void addSettled(const PosedScan& scan, const ScanLabels& labels, const Eigen::Vector3d& offset);
  void addTimes(std::uint64_t scan, const std::vector<std::pair<std::string, double>>& times);
  /// Shares what the method had left to do when the log ended [ms] equally among the scans, as a
  /// stage of its own: most scans of a short log enter the map then.
  void addRest(double milliseconds);
  /// Writes the map, which is final, in both its forms; may run beside addSettled().
  void writeStaticMap(const MultiLidarPipeline& pipeline);
  /// Writes what is left and gives all files their names. Files of an earlier run are gone then.
  void finish();

  /// What pictures show; complete after finish().
  const MapContent& content() const { return content_; }
  const RunCounts& counts() const { return counts_; }
  /// Scans mapped, by label of the LiDAR.
  const std::map<std::string, std::uint64_t>& scansOf() const { return scansOf_; }
  /// Milliseconds of each stage by scan, in the order of the scans.
  const std::vector<std::pair<std::string, std::vector<double>>>& times() const { return times_; }

 private:
  void removeEarlierRun() const;
  void addMoving(const PosedScan& scan, const ScanLabels& labels);
  void writeTimings() const;

  std::filesystem::path folder_;
  AtomicFolder labels_;
  /// Empty where they are not asked for.
  std::unique_ptr<AtomicFolder> liveLabels_, instances_;
  /// Made with the first scan, which tells the offset.
  std::unique_ptr<PlyWriter> movingPoints_;
  /// Made with the map.
  std::unique_ptr<PlyWriter> staticMap_;
  AtomicFile metricMap_;
  TracksCsvWriter tracks_;
  FilteredRawlogWriter filtered_;
  /// By label of the LiDAR, whose scans hold its own traces only.
  std::map<std::string, TrackPathCollector> paths_;
  std::map<std::string, std::uint64_t> scansOf_;
  /// Label of the LiDAR whose way is drawn: that of the first scan.
  std::optional<std::string> shownLidar_;
  PointSample staticSample_, movingSample_;
  MapContent content_;
  RunCounts counts_;
  std::vector<std::uint64_t> timedScans_;
  std::vector<std::pair<std::string, std::vector<double>>> times_;
};

}  // namespace toss
