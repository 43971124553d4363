// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/mapping/VoxelMap.h>
#include <toss/pipeline/ScanLabels.h>

#include <memory>
#include <vector>

namespace toss {

/// A trace as it is shown.
struct LiveTrace {
  TrackSample sample;
  /// Whether its verdict has changed in the last second.
  bool flipped = false;
  /// Centres of its boxes so far, in order of time [m], map frame.
  std::vector<Eigen::Vector3d> path;
};

/// What is shown after one scan. Map frame, [m].
struct LiveFrame {
  /// PosedScan::index, and seconds since the first scan shown.
  std::uint64_t scan = 0;
  double time = 0.0;
  Eigen::Isometry3d mapFromSensor = Eigen::Isometry3d::Identity();
  /// The scan's returns by its live labels: ground, what stands above it, and what moves.
  std::vector<MapPoint> ground, standing, moving;
  std::vector<LiveTrace> traces;
  /// Positions of the sensor so far.
  std::vector<Eigen::Vector3d> trajectory;
  /// The map by present knowledge; another object whenever it was renewed. Never null.
  std::shared_ptr<const std::vector<MapPoint>> map;
  /// Changes of a trace's verdict so far, and duration of the method for this scan [ms].
  std::size_t flips = 0;
  double milliseconds = 0.0;
};

/// What can be switched on and off.
enum class Layer { Ground, Standing, Moving, Boxes, Map, Trajectory };
constexpr int kLayerCount = 6;

/// Which layers are shown, and how.
struct LayerChoice {
  bool shown[kLayerCount] = {true, true, true, true, true, true};
  /// Edge of a point of the scan [px]; those of the map are a pixel smaller.
  double pointSize = 3.0;

  bool has(Layer layer) const { return shown[static_cast<int>(layer)]; }
};

}  // namespace toss
