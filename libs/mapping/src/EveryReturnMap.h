// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/mapping/StaticMap.h>
#include <tsl/robin_map.h>

namespace toss {

/// The static map without voxels: every kept return is a point, in order of its coming. Holds
/// 16 bytes per return of the whole log.
class EveryReturnMap : public StaticMap {
 public:
  EveryReturnMap(const MappingOptions& options, const Eigen::Vector3d& origin);

  void addPermanent(const ScanReturns& scan, IndexSpan indices) override;
  void addBox(BoxId box, TrackId track, const ScanReturns& scan, IndexSpan indices,
              bool dynamic) override;
  void addToTrack(TrackId track, const ScanReturns& scan, IndexSpan indices) override;
  ScanPlaces placesOf(const ScanReturns& scan) const override { return {scan.level}; }
  bool holds(VoxelKey, double) override { return false; }
  void setDynamic(BoxId box, bool dynamic) override;
  void fold(BoxId box) override;
  void revokeTrack(TrackId track) override;
  void settleBox(BoxId box) override;
  void settleTrack(TrackId track) override { ofTrack_.erase(track); }
  void finish() override;
  void leaveBehind(const Eigen::Vector3d&) override {}
  void visitPoints(const Eigen::Vector3d& offset,
                   const std::function<void(const MapPoint&)>& visit) const override;
  std::size_t size() const override { return size_; }
  std::size_t ledgerBytes() const override;
  std::size_t leftOut() const override { return leftOut_; }

 private:
  /// The returns of one call.
  struct Group {
    std::vector<MapPoint> points;
    bool kept = true;
  };
  using GroupIndex = std::size_t;
  struct Box {
    TrackId track = 0;
    GroupIndex group = 0;
  };
  using Boxes = tsl::robin_map<BoxId, Box>;

  GroupIndex addGroup(const ScanReturns& scan, IndexSpan indices, bool kept);
  Boxes::iterator find(BoxId box);
  void keep(GroupIndex group, bool kept);
  /// Gives up the returns of a group that is not kept.
  void settle(GroupIndex group);

  /// Added to all coordinates [m]; zero near the origin of the frame, where floats are exact
  /// enough.
  Eigen::Vector3d origin_;
  std::vector<Group> groups_;
  Boxes ofBox_;
  tsl::robin_map<TrackId, std::vector<GroupIndex>> ofTrack_;
  std::size_t size_ = 0, leftOut_ = 0;
};

}  // namespace toss
