// SPDX-License-Identifier: BSD-3-Clause
#include <toss/mapping/RevocableMap.h>
#include <tsl/robin_map.h>

#include <stdexcept>
#include <string>

#include "TraceLedger.h"

namespace toss {

namespace {

struct BoxLedger {
  TrackId track = 0;
  bool dynamic = false;
  std::vector<VoxelContribution> contributions;
};

}  // namespace

struct RevocableMap::Implementation {
  VoxelMap voxels;
  /// [m]
  double keepRadius;
  tsl::robin_map<BoxId, BoxLedger> boxes;
  tsl::robin_map<TrackId, TraceLedger> traces;

  tsl::robin_map<BoxId, BoxLedger>::iterator find(BoxId box) {
    const auto found = boxes.find(box);
    if (found == boxes.end()) {
      throw std::logic_error("RevocableMap: box " + std::to_string(box) + " is unknown or settled");
    }
    return found;
  }
};

RevocableMap::RevocableMap(const MappingOptions& options, const Eigen::Vector3d& origin,
                           TileStore* store) {
  options.check();
  implementation_.reset(
      new Implementation{VoxelMap(options.voxelSize, origin, options.tileSize, store),
                         options.tilesKeepRadius,
                         {},
                         {}});
}

void RevocableMap::leaveBehind(const Eigen::Vector3d& position) {
  implementation_->voxels.leaveBehind(position, implementation_->keepRadius);
}

RevocableMap::~RevocableMap() = default;

const VoxelMap& RevocableMap::voxels() const {
  return implementation_->voxels;
}

void RevocableMap::addPermanent(const std::vector<VoxelContribution>& contributions) {
  implementation_->voxels.add(contributions);
}

void RevocableMap::addPermanent(const VoxelContribution* first, const VoxelContribution* last) {
  implementation_->voxels.add(first, last);
}

void RevocableMap::addBox(BoxId box, TrackId track, std::vector<VoxelContribution> contributions,
                          bool dynamic) {
  const auto [place, isNew] = implementation_->boxes.try_emplace(box);
  if (!isNew) throw std::logic_error("RevocableMap: box " + std::to_string(box) + " comes twice");
  if (!dynamic) implementation_->voxels.add(contributions);
  place.value() = {track, dynamic, std::move(contributions)};
}

void RevocableMap::addToTrack(TrackId track, const std::vector<VoxelContribution>& contributions) {
  implementation_->voxels.add(contributions);
  if (track != 0) implementation_->traces[track].add(contributions);
}

void RevocableMap::setDynamic(BoxId box, bool dynamic) {
  BoxLedger& ledger = implementation_->find(box).value();
  if (ledger.dynamic == dynamic) return;
  ledger.dynamic = dynamic;
  if (dynamic) {
    implementation_->voxels.subtract(ledger.contributions);
  } else {
    implementation_->voxels.add(ledger.contributions);
  }
}

void RevocableMap::fold(BoxId box) {
  const auto place = implementation_->find(box);
  const BoxLedger& ledger = place->second;
  if (!ledger.dynamic && ledger.track != 0) {
    implementation_->traces[ledger.track].add(ledger.contributions);
  }
  implementation_->boxes.erase(place);
}

void RevocableMap::revokeTrack(TrackId track) {
  const auto place = implementation_->traces.find(track);
  if (place == implementation_->traces.end()) return;
  implementation_->voxels.subtract(place->second.sums());
  implementation_->traces.erase(place);
}

void RevocableMap::settleBox(BoxId box) {
  implementation_->boxes.erase(implementation_->find(box));
}

void RevocableMap::settleTrack(TrackId track) {
  implementation_->traces.erase(track);
}

void RevocableMap::finish() {
  implementation_->boxes.clear();
  implementation_->traces.clear();
}

std::size_t RevocableMap::ledgerBytes() const {
  std::size_t bytes = implementation_->boxes.bucket_count() * sizeof(BoxLedger) +
                      implementation_->traces.bucket_count() * sizeof(TraceLedger);
  for (const auto& [box, ledger] : implementation_->boxes) {
    bytes += ledger.contributions.capacity() * sizeof(VoxelContribution);
  }
  for (const auto& [track, ledger] : implementation_->traces) bytes += ledger.bytes();
  return bytes;
}

}  // namespace toss
