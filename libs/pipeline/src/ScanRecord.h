// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/mapping/StaticMap.h>
#include <toss/pipeline/ScanLabels.h>
#include <toss/segmentation/Segmentation.h>
#include <toss/visibility/EvidenceCells.h>
#include <toss/voting/DsVoting.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

namespace toss {

/// What decides about a group of returns of one scan: an instance, or the box of a trace that
/// claims returns.
struct Owner {
  /// Trace, 0 = none.
  TrackId track = 0;
  /// Box that is voted on; meaningful where `votes`.
  BoxId box = 0;
  bool votes = false;
  /// An instance, as against a claim.
  bool instance = false;
  /// For returns that a trace claims out of a standing instance: that instance, with which they
  /// move as well, 0 = none.
  std::int32_t host = 0;
  /// Whether the static map has taken returns of it: then they have a ledger there.
  bool mapped = false;
  /// What views say about the instance; empty for claims.
  FreeSpaceSum evidence;

  /// Of what a trace claims. It is residue: what may be left of the trace's object, as this scan
  /// alone can not tell it from what it stands on or beside. While the trace is dynamic it is not
  /// in the map; it moves where nothing that is static was ever measured in its place.
  static Owner ofClaim(TrackId track, std::int32_t host) {
    Owner owner;
    owner.track = track, owner.host = host;
    return owner;
  }
};

/// One scan from the time it came in until its labels are final. Index-aligned with its points.
struct ScanRecord {
  /// Index into `owners`: two bytes, as records of a minute are kept. Returns of owners that it
  /// can not name, beyond any that a scan was seen to have, are nobody's.
  using OwnerIndex = std::uint16_t;
  static OwnerIndex ownerIndex(std::int32_t owner) {
    return owner <= std::numeric_limits<OwnerIndex>::max() ? static_cast<OwnerIndex>(owner)
                                                           : OwnerIndex{0};
  }

  std::uint64_t scan = 0;
  double time = 0.0;
  Eigen::Vector3d sensorPosition = Eigen::Vector3d::Zero();
  /// Shape [n].
  std::vector<PointClass> pointClass;
  std::vector<OwnerIndex> owner;
  /// Returns that traces have claimed, ascending; and the place of each in the static map, from
  /// the time on when the scan is in it.
  std::vector<std::int32_t> residue;
  std::vector<VoxelKey> residuePlace;
  /// Returns that move although nothing that owns them does, ascending; set with the evidence, and
  /// completed by residue when the scan is settled.
  std::vector<std::int32_t> loneMovers;
  /// owners[0] is nobody; instance k is owners[k]; claims follow.
  std::vector<Owner> owners;
  /// Which of them move, shape [owners]; set when that is known for good.
  std::vector<bool> moving;
  /// Ledger of owners[0] in the static map; the others follow.
  BoxId firstLedger = 0;
  /// By ascending trace; those from `firstNewTrack` on were never seen before.
  std::vector<TrackSample> tracks;
  TrackId firstNewTrack = 0;
  /// Whether all views have testified and the returns are in the static map. Until then the
  /// coordinates are kept.
  bool complete = false;
  LevelPoints level;
  std::vector<float> intensity;

  /// The first sample of a trace that is not before `track`.
  std::vector<TrackSample>::const_iterator samplesFrom(TrackId track) const {
    return std::lower_bound(
        tracks.begin(), tracks.end(), track,
        [](const TrackSample& sample, TrackId before) { return sample.track < before; });
  }
  /// The sample of a trace, nullptr where the scan has none.
  const TrackSample* sampleOf(TrackId track) const {
    const auto sample = samplesFrom(track);
    return sample != tracks.end() && sample->track == track ? &*sample : nullptr;
  }

  /// `loneMovers` as marks, shape [n].
  std::vector<bool> loneMoverMarks() const {
    std::vector<bool> marks(owner.size(), false);
    for (const std::int32_t point : loneMovers) marks[static_cast<std::size_t>(point)] = true;
    return marks;
  }
};

}  // namespace toss
