// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/mapping/StaticMap.h>
#include <toss/pipeline/Pipeline.h>

#include <memory>
#include <vector>

namespace toss {

/// What pipelines of several LiDARs have in common: the static map, and numbers that must not be
/// given twice.
struct SharedMap {
  /// nullptr = the map stays in memory.
  TileStore* tiles = nullptr;
  /// Made with the first scan that is complete; null before.
  std::unique_ptr<StaticMap> map;
  /// Taken off the points of the map that are visited [m]; known with the first scan.
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();
  BoxId nextLedger = 0;
  /// Number of the trace that was started last.
  std::shared_ptr<TrackId> lastTrack = std::make_shared<TrackId>(0);
  /// Those whose scans have ledgers in the map.
  std::vector<const Pipeline::Implementation*> pipelines;
};

}  // namespace toss
