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
/// other kind than to any of their own; returns farther than one cell are not looked for. Where the
/// nearest return is not annotated, the nearest annotated one stands in for it if that is static:
/// most surfaces are annotated in some scans and not in others. If it moves, the point may as well
/// be what stands beside the mover, and keeps class 0.
class MapTruth {
 public:
  /// `map`: its labels are replaced. `cellSize` [m]: reach of the search. `ignoreUnlabelled`:
  /// whether class 0 means "not annotated"; else it is static like others.
  MapTruth(LabelledCloud map, double cellSize, bool ignoreUnlabelled);

  /// Takes one scan, ordered by cells of `cellSize`. `label` is indexed as the cloud behind `scan`.
  /// Returns with `squaredDistance` the nearest map point of each place of `scan` [m^2], infinity
  /// beyond one cell.
  void addScan(const CellOrder& scan, const std::vector<std::uint32_t>& label,
               std::vector<double>& squaredDistance);

  /// The map with its labels: class 0 where it is not known what is there, `unseenLabel` where no
  /// return is near.
  LabelledCloud labelled(std::uint32_t unseenLabel) const;
  /// Points of the map that no return is near.
  std::uint64_t unseenPoints() const;

 private:
  struct Nearest {
    double squared;
    std::int64_t scan = -1;
    std::uint32_t index = 0, label = 0;
  };

  /// Takes a return of the present scan as the nearest one where it is.
  void offer(double squared, std::uint32_t returnIndex, std::uint32_t label, Nearest& best) const;
  std::uint32_t labelOf(std::size_t place) const;

  bool ignoreUnlabelled_;
  LabelledCloud map_;
  CellOrder order_;
  /// Nearest return, and nearest annotated return (only where class 0 is ignored), by place in
  /// order_.
  std::vector<Nearest> nearest_, nearestAnnotated_;
  std::int64_t scans_ = 0;
};

}  // namespace toss
