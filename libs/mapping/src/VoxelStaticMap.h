// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/mapping/RevocableMap.h>
#include <toss/mapping/StaticMap.h>

namespace toss {

/// The static map as voxels: bins the returns of each call and enters them into a RevocableMap.
class VoxelStaticMap : public StaticMap {
 public:
  VoxelStaticMap(const MappingOptions& options, const Eigen::Vector3d& origin, TileStore* store);

  void addPermanent(const ScanReturns& scan, IndexSpan indices) override;
  void addBox(BoxId box, TrackId track, const ScanReturns& scan, IndexSpan indices,
              bool dynamic) override;
  void addToTrack(TrackId track, const ScanReturns& scan, IndexSpan indices) override;
  void addScan(const ScanReturns& scan, const std::vector<std::int32_t>& owner,
               const std::vector<bool>& dynamic, BoxId firstBox) override;
  /// Bins the next scan while one is entered.
  void addDecided(std::size_t count, const std::function<DecidedScan(std::size_t)>& scan) override;
  ScanPlaces placesOf(const ScanReturns& scan) const override {
    return map_.voxels().placesOf(scan.level, scan.sensorPosition);
  }
  bool holds(VoxelKey place, double size) override { return map_.holds(place, size); }
  void setDynamic(BoxId box, bool dynamic) override { map_.setDynamic(box, dynamic); }
  void fold(BoxId box) override { map_.fold(box); }
  void revokeTrack(TrackId track) override { map_.revokeTrack(track); }
  void settleBox(BoxId box) override { map_.settleBox(box); }
  void settleTrack(TrackId track) override { map_.settleTrack(track); }
  void finish() override { map_.finish(); }
  void leaveBehind(const Eigen::Vector3d& position) override { map_.leaveBehind(position); }
  void visitPoints(const Eigen::Vector3d& offset,
                   const std::function<void(const MapPoint&)>& visit) const override {
    map_.voxels().visitPoints(minPoints_, offset, visit);
  }
  std::size_t size() const override { return map_.voxels().size(minPoints_); }
  std::size_t ledgerBytes() const override { return map_.ledgerBytes(); }
  std::size_t leftOut() const override { return leftOut_; }

 private:
  const std::vector<VoxelRun>& bin(const ScanReturns& scan, IndexSpan indices);
  /// Returns how many returns were left out.
  std::size_t binByOwner(const ScanReturns& scan, const std::vector<std::int32_t>& owner,
                         BinnedReturns& binned) const;

  RevocableMap map_;
  std::uint32_t cap_, minPoints_;
  std::size_t leftOut_ = 0;
  std::vector<VoxelRun> runs_;
  BinnedReturns binned_;
};

}  // namespace toss
