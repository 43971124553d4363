// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/mapping/VoxelMap.h>
#include <toss/pipeline/ScanLabels.h>

#include <Eigen/Core>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace toss {

/// The way of one moving trace.
struct TrackPath {
  TrackId track = 0;
  /// Its box in each scan in which it moved, in order of time, map frame [m].
  std::vector<Box> boxes;
};

/// Gathers the ways of the moving traces from the labels of one scan after the other: of long logs
/// those that were seen moving in most scans, so that its memory does not grow with their number.
class TrackPathCollector {
 public:
  /// `limit`: traces that are over of which the ways are kept; up to as many more for a while.
  explicit TrackPathCollector(std::size_t limit = 4000) : limit_(limit) {}

  /// `offset` [m] is taken off the coordinates.
  void add(const ScanLabels& labels, const Eigen::Vector3d& offset = Eigen::Vector3d::Zero());
  /// By ascending number of the trace.
  std::vector<TrackPath> paths() const;
  /// Moving traces that came by.
  std::uint64_t count() const { return dropped_ + paths_.size(); }

 private:
  /// Drops the shortest ways of traces that are not in the scan of `labels` and thus over.
  void dropShortest(const ScanLabels& labels);

  std::size_t limit_;
  std::map<TrackId, TrackPath> paths_;
  std::uint64_t dropped_ = 0;
};

/// What pictures and scenes of a run show; what is empty is left out. Map frame less `offset`, [m].
struct MapContent {
  /// Name of the input, for titles.
  std::string name;
  std::vector<MapPoint> staticPoints;
  /// Points of the map of which they are a sample; 0 = they are all.
  std::uint64_t staticCount = 0;
  /// Returns taken out as moving; of long runs a PointSample.
  std::vector<MapPoint> movingPoints;
  /// Added to all coordinates [m]; not zero for maps far from the origin, see mapOffset().
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();
  /// Positions of the sensor, in order of time.
  std::vector<Eigen::Vector3d> trajectory;
  std::vector<TrackPath> tracks;
  /// Moving traces of which they are the longest ways; 0 = they are all.
  std::uint64_t trackCount = 0;
};

/// Puts together what is given to `toss snapshot`: point files (all static), and folders that
/// `toss map` has written (static_map.ply, moving_points.ply and tracks.csv, as far as they are
/// there). At most `limit` moving points are kept. Throws UserError for anything else.
MapContent readMapContent(const std::vector<std::filesystem::path>& inputs, std::size_t limit);

}  // namespace toss
