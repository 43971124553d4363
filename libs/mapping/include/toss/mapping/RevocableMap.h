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
  /// Throws UserError for options out of range.
  RevocableMap(const MappingOptions& options, const Eigen::Vector3d& origin);
  ~RevocableMap();

  /// The voxel map with what is static by present knowledge.
  const VoxelMap& voxels() const;

  /// Adds returns that can not move any more: ground, background.
  void addPermanent(const std::vector<VoxelContribution>& contributions);
  /// Enters a box with its returns; they are in the map while the box is static. Box ids ascend.
  void addBox(BoxId box, TrackId track, std::vector<VoxelContribution> contributions, bool dynamic);
  /// Label of a box that is neither folded nor settled.
  void setDynamic(BoxId box, bool dynamic);
  /// Moves the box's returns to the ledger of its trace: from now on they are static or dynamic
  /// with revokeTrack alone. A box that is dynamic at this time is dropped from the map for good.
  void fold(BoxId box);
  /// Takes all folded returns of the trace out of the map.
  void revokeTrack(TrackId track);
  /// Settles a box or a trace: its present label stands for ever, its ledger is dropped.
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
