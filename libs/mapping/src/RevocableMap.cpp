// SPDX-License-Identifier: BSD-3-Clause
#include <toss/mapping/RevocableMap.h>
#include <tsl/robin_map.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "ScanLedger.h"
#include "TraceLedger.h"

namespace toss {

namespace {

/// Runs of the boxes of one call, held by the ledgers of these boxes.
using Held = std::shared_ptr<ScanLedger>;

struct BoxLedger {
  TrackId track = 0;
  bool dynamic = false;
  /// Whose runs of `held` are those of this box.
  std::size_t owner = 0;
  Held held;

  RunSpan runs() const { return held->of(owner); }
};

/// Spare memory that is kept: a scan is settled for each that comes.
constexpr std::size_t kSpares = 2;

}  // namespace

struct RevocableMap::Implementation {
  VoxelMap voxels;
  /// [m]
  double keepRadius;
  tsl::robin_map<BoxId, BoxLedger> boxes;
  tsl::robin_map<TrackId, TraceLedger> traces;
  /// Memory of scans whose boxes are all settled.
  std::vector<Held> spares;

  Held spareOrNew() {
    if (spares.empty()) return std::make_shared<ScanLedger>();
    const Held spare = std::move(spares.back());
    spares.pop_back();
    return spare;
  }
  void enter(BoxId box, BoxLedger ledger) {
    const auto [place, isNew] = boxes.try_emplace(box, std::move(ledger));
    if (!isNew) throw std::logic_error("RevocableMap: box " + std::to_string(box) + " comes twice");
  }
  void erase(tsl::robin_map<BoxId, BoxLedger>::iterator place) {
    const Held held = std::move(place.value().held);
    boxes.erase(place);
    if (held.use_count() == 1 && spares.size() < kSpares) spares.push_back(held);
  }
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
                         {},
                         {}});
}

void RevocableMap::leaveBehind(const Eigen::Vector3d& position) {
  implementation_->voxels.leaveBehind(position, implementation_->keepRadius);
}

RevocableMap::~RevocableMap() = default;

bool RevocableMap::holds(VoxelKey voxel, double size) {
  int bits = 0;
  while (bits < kBlockBits && std::ldexp(implementation_->voxels.voxelSize(), bits) < size) ++bits;
  return implementation_->voxels.holds(voxel, bits);
}

const VoxelMap& RevocableMap::voxels() const {
  return implementation_->voxels;
}

void RevocableMap::addPermanent(const RunSpan& runs) {
  implementation_->voxels.add(runs);
}

void RevocableMap::addBox(BoxId box, TrackId track, std::vector<VoxelRun> runs, bool dynamic) {
  const Held held = std::make_shared<ScanLedger>();
  held->swap(runs);
  implementation_->enter(box, {track, dynamic, 0, held});
  if (!dynamic) implementation_->voxels.add(held->all());
}

void RevocableMap::addScan(BinnedReturns& binned, const std::vector<bool>& dynamic,
                           BoxId firstBox) {
  const Held held = implementation_->spareOrNew();
  held->swap(binned.owned);
  for (std::size_t owner = 1; owner < held->owners(); ++owner)
    if (held->count(owner) > 0)
      implementation_->enter(firstBox + owner, {0, dynamic[owner], owner, held});
  implementation_->voxels.add(binned.permanent);
  implementation_->voxels.add(held->all(), &dynamic);
}

void RevocableMap::addToTrack(TrackId track, const RunSpan& runs) {
  implementation_->voxels.add(runs);
  if (track != 0) implementation_->traces[track].add(runs);
}

void RevocableMap::setDynamic(BoxId box, bool dynamic) {
  BoxLedger& ledger = implementation_->find(box).value();
  if (ledger.dynamic == dynamic) return;
  ledger.dynamic = dynamic;
  if (dynamic) {
    implementation_->voxels.subtract(ledger.runs());
  } else {
    implementation_->voxels.add(ledger.runs());
  }
}

void RevocableMap::fold(BoxId box) {
  const auto place = implementation_->find(box);
  const BoxLedger& ledger = place->second;
  if (!ledger.dynamic && ledger.track != 0) {
    implementation_->traces[ledger.track].add(ledger.runs());
  }
  implementation_->erase(place);
}

void RevocableMap::revokeTrack(TrackId track) {
  const auto place = implementation_->traces.find(track);
  if (place == implementation_->traces.end()) return;
  place->second.subtractFrom(implementation_->voxels);
  implementation_->traces.erase(place);
}

void RevocableMap::settleBox(BoxId box) {
  implementation_->erase(implementation_->find(box));
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
    bytes += ledger.held->count(ledger.owner) * sizeof(VoxelRun);
  }
  for (const auto& [track, ledger] : implementation_->traces) bytes += ledger.bytes();
  return bytes;
}

}  // namespace toss
