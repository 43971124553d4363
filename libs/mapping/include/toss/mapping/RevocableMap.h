// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/mapping/MappingOptions.h>
#include <toss/mapping/VoxelMap.h>
#include <toss/tracking/Track.h>
#include <toss/voting/DsVoting.h>

#include <memory>
#include <vector>

namespace toss {

/// The static map with the ledgers that let it take back what turns out to move (spec section 8.3).
/// Invariant: after any sequence of calls the voxels equal, bit for bit, those of a map built from
/// the present labels alone.
class RevocableMap {
 public:
  /// `store`: takes what is far away, see leaveBehind(). Throws UserError for options out of range.
  RevocableMap(const MappingOptions& options, const Eigen::Vector3d& origin,
               TileStore* store = nullptr);
  ~RevocableMap();

  /// The voxel map with what is static by present knowledge.
  const VoxelMap& voxels() const;

  /// Whether returns that are static by present knowledge lie in the place of a voxel: the cube of
  /// 2^k voxels a side around it that is nearest to `size` [m] from above, at most 4 voxels.
  bool holds(VoxelKey voxel, double size);

  /// Puts tiles of the voxels into the store that are far from `position` [m, map frame].
  void leaveBehind(const Eigen::Vector3d& position);

  /// Adds returns that can not move any more: ground, background.
  void addPermanent(const RunSpan& runs);
  /// Enters a box with its returns; they are in the map while the box is static. Throws
  /// std::logic_error for a box that was entered before.
  void addBox(BoxId box, TrackId track, std::vector<VoxelRun> runs, bool dynamic);
  /// Enters a whole scan: what is permanent, and each owner k > 0 that has runs as a box of the
  /// number firstBox + k without a trace, `dynamic` where dynamic[k]. Takes the runs of the owners
  /// out of `binned` and leaves memory of an earlier scan in their place.
  void addScan(BinnedReturns& binned, const std::vector<bool>& dynamic, BoxId firstBox);
  /// Adds returns that have no box but go with a trace: as if a static box of theirs had been
  /// folded.
  void addToTrack(TrackId track, const RunSpan& runs);
  /// Label of a box that is neither folded nor settled; std::logic_error for other boxes.
  void setDynamic(BoxId box, bool dynamic);
  /// Moves the box's returns to the ledger of its trace: from now on they are static or dynamic
  /// with revokeTrack alone. A box that is dynamic at this time is dropped from the map for good; a
  /// static one without a trace is settled.
  void fold(BoxId box);
  /// Takes all folded returns of the trace out of the map; no effect where it has none.
  void revokeTrack(TrackId track);
  /// Settles a box or a trace: its present label stands for ever, its ledger is dropped. Throws
  /// std::logic_error for an unknown box; a trace without folded returns has no effect.
  void settleBox(BoxId box);
  void settleTrack(TrackId track);
  /// Settles everything.
  void finish();

  /// Bytes held by ledgers, for reports.
  std::size_t ledgerBytes() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace toss
