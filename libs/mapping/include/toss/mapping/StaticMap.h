// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/mapping/MappingOptions.h>
#include <toss/mapping/ScanPlaces.h>
#include <toss/mapping/VoxelMap.h>
#include <toss/segmentation/Segmentation.h>
#include <toss/tracking/Track.h>
#include <toss/voting/DsVoting.h>

#include <functional>
#include <memory>
#include <vector>

namespace toss {

/// The returns of one scan as the map takes them. Refers to buffers of the caller.
struct ScanReturns {
  /// Coordinates of all returns in the level frame [m], shape [n].
  const LevelPoints& level;
  /// Intensities in the unit of the input, shape [n], or empty: then all count as 0.
  const std::vector<float>& intensity;
  /// Position of the sensor [m], map frame: map coordinate = level coordinate + this.
  Eigen::Vector3d sensorPosition;
};

/// The map of what stays, from which everything that turns out to move can be taken back
/// (spec section 8). Its points depend on the present labels alone, not on how they came about.
/// Returns that are not finite, or farther from the map's origin than the map reaches, are left out
/// and counted. All calls throw UserError where the sensor itself is out of the map's reach.
class StaticMap {
 public:
  virtual ~StaticMap() = default;

  /// Adds returns that can not move any more: ground, background, returns without a cluster.
  virtual void addPermanent(const ScanReturns& scan, IndexSpan indices) = 0;
  /// Enters a box with its returns; they are in the map while the box is static. `box` is any
  /// number that was not entered before (else std::logic_error).
  /// `track` 0: the box has no trace.
  virtual void addBox(BoxId box, TrackId track, const ScanReturns& scan, IndexSpan indices,
                      bool dynamic) = 0;
  /// Adds returns that have no box but go with a trace: in the map until revokeTrack, as if a
  /// static box of theirs had been folded. For what a predicted box claims.
  virtual void addToTrack(TrackId track, const ScanReturns& scan, IndexSpan indices) = 0;
  /// Enters a whole scan: returns whose `owner` (shape [n]) is 0 as addPermanent does, those of
  /// owner k > 0 as a box of the number firstBox + k without a trace does, where there are any;
  /// those below 0 are passed over. `dynamic`: shape [owners].
  virtual void addScan(const ScanReturns& scan, const std::vector<std::int32_t>& owner,
                       const std::vector<bool>& dynamic, BoxId firstBox);
  /// A whole scan whose labels are final. Refers to buffers of the caller.
  struct DecidedScan {
    ScanReturns returns;
    /// Shape [n]; returns stay where it is 0 or greater, those below 0 are passed over.
    const std::vector<std::int32_t>& owner;
  };
  /// Enters scans 0 .. count - 1 one after the other: the same as addScan(), settleBox() for each
  /// owner and leaveBehind() the sensor's position, without keeping ledgers. `scan(i)` is asked for
  /// each in turn, and what it has given is looked at until it is asked again. With several threads
  /// allowed it may be asked by another than the caller's while scans before are still entered: of
  /// the map it may use placesOf() alone.
  virtual void addDecided(std::size_t count, const std::function<DecidedScan(std::size_t)>& scan);

  /// Names of the places of a scan's returns, for holds().
  virtual ScanPlaces placesOf(const ScanReturns& scan) const = 0;
  /// Whether any static return is in a place by present labels; places are as large as `size` [m]
  /// or as a voxel, see RevocableMap. A map without voxels holds none.
  virtual bool holds(VoxelKey place, double size) = 0;

  /// Label of a box that is neither folded nor settled; std::logic_error for other boxes.
  virtual void setDynamic(BoxId box, bool dynamic) = 0;
  /// Moves the box's returns to the ledger of its trace: from now on they are static or dynamic
  /// with revokeTrack alone. A box that is dynamic at this time is dropped from the map for good; a
  /// static one without a trace is settled.
  virtual void fold(BoxId box) = 0;
  /// Takes all folded returns of the trace out of the map; no effect where it has none.
  virtual void revokeTrack(TrackId track) = 0;
  /// Settles a box: its present label stands for ever, its ledger is dropped.
  virtual void settleBox(BoxId box) = 0;
  /// Settles the folded returns of a trace; no effect where it has none.
  virtual void settleTrack(TrackId track) = 0;
  /// Settles everything.
  virtual void finish() = 0;

  /// Lets what is far from `position` [m, map frame] out of memory, where the map has a store.
  virtual void leaveBehind(const Eigen::Vector3d& position) = 0;

  /// Calls `visit` for each point of the map by present knowledge, in an order that depends on the
  /// returns alone. Coordinates are less `offset` [m, map frame], so that maps far from the origin
  /// of their frame keep their precision.
  virtual void visitPoints(const Eigen::Vector3d& offset,
                           const std::function<void(const MapPoint&)>& visit) const = 0;
  /// All of them.
  std::vector<MapPoint> points(const Eigen::Vector3d& offset = Eigen::Vector3d::Zero()) const;
  /// Points that points() would give.
  virtual std::size_t size() const = 0;
  /// Bytes held by ledgers, for reports.
  virtual std::size_t ledgerBytes() const = 0;
  /// Returns that were left out because they were not finite or out of reach.
  virtual std::size_t leftOut() const = 0;
};

/// The map that `options` ask for: voxels, or every return where voxelSize is 0. `origin`: map
/// coordinates [m] near which the map lies, e.g. the first sensor position; corner of voxel 0,0,0.
/// `store`: outlives the map and takes its voxels that are far away; nullptr = all stay in memory.
/// Throws UserError for options out of range.
std::unique_ptr<StaticMap> makeStaticMap(const MappingOptions& options,
                                         const Eigen::Vector3d& origin, TileStore* store = nullptr);

}  // namespace toss
