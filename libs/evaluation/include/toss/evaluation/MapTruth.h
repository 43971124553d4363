// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/evaluation/CellOrder.h>
#include <toss/evaluation/LabelledCloud.h>

#include <cstdint>
#include <vector>

namespace toss {

/// Gives the points of a finished map, by whatever program, their true labels: that of the nearest
/// return of all scans (the earliest scan, then the lowest index where several are). An
/// approximation where the map's points are centroids, which may lie nearer to a return of the
/// other kind than to any of their own; returns farther than one cell are not looked for.
class MapTruth {
 public:
  /// `map`: its labels are replaced. `cellSize` [m]: reach of the search.
  MapTruth(LabelledCloud map, double cellSize);

  /// Takes one scan, ordered by cells of `cellSize`. `label` is indexed as the cloud behind `scan`.
  /// Returns with `squaredDistance` the nearest map point of each place of `scan` [m^2], infinity
  /// beyond one cell.
  void addScan(const CellOrder& scan, const std::vector<std::uint32_t>& label,
               std::vector<double>& squaredDistance);

  /// The map with its labels; `unknownLabel` where no return is near.
  LabelledCloud labelled(std::uint32_t unknownLabel) const;
  /// Points of the map that no return is near.
  std::uint64_t unknownPoints() const;

 private:
  /// Takes the return as the nearest one of a map point where it is.
  void offer(std::uint32_t place, double squared, std::uint32_t returnIndex, std::uint32_t label);

  struct Nearest {
    double squared;
    std::int64_t scan = -1;
    std::uint32_t index = 0, label = 0;
  };
  double cellSize_;
  LabelledCloud map_;
  CellOrder order_;
  /// By place in order_.
  std::vector<Nearest> nearest_;
  std::int64_t scans_ = 0;
};

}  // namespace toss
