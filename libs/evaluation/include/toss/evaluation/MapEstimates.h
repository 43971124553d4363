// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/evaluation/CellOrder.h>
#include <toss/evaluation/LabelledCloud.h>

#include <cstdint>
#include <vector>

namespace toss {

/// Accumulates maps as ERASOR does (spec section 9.3): each scan is voxelised, the scans are
/// joined, and the whole is voxelised again. Several maps of the same scans at once: the truth,
/// which keeps every point, and estimates, which keep some of them. Voxels that come out alike are
/// held once, so that a further estimate costs memory only where it differs.
class MapEstimates {
 public:
  /// Most maps that can be held together.
  static constexpr int kMost = 16;
  /// Membership bit of map `number`.
  static constexpr std::uint16_t bit(int number) {
    return static_cast<std::uint16_t>(1u << number);
  }

  /// `count` maps, numbered from 0, in voxels of `voxelSize` [m].
  MapEstimates(double voxelSize, int count);

  /// Adds one scan: its points in the frame of the evaluation, ordered by cells of `voxelSize`. Map
  /// e keeps the points with bit(e) set in `membership`; the points of map 0 include all others'.
  /// `label` and `membership` are indexed as the cloud behind `order`.
  void addScan(const CellOrder& order, const std::vector<std::uint32_t>& label,
               const std::vector<std::uint16_t>& membership);

  /// Map `number` from all scans so far.
  LabelledCloud voxelized(int number);

 private:
  /// One map's voxels of one scan, ascending by key.
  struct ScanVoxels {
    LabelledCloud cloud;
    std::vector<CellKey> key;
    std::size_t cursor = 0;
  };

  void voxelizeScan(const CellOrder& order, const std::vector<std::uint32_t>& label,
                    const std::vector<std::uint16_t>& membership);
  void join();
  void addVoxel(const LabelledCloud& cloud, std::size_t i, std::uint16_t mapBit,
                std::size_t cellBegin);

  double voxelSize_;
  std::vector<ScanVoxels> scan_;
  CellOrder selected_;
  LabelledCloud joined_;
  std::vector<std::uint16_t> membership_;
  CellOrder joinedOrder_;
  bool ordered_ = false;
};

}  // namespace toss
