// SPDX-License-Identifier: BSD-3-Clause
#include <toss/mapping/RevocableMap.h>
#include <tsl/robin_map.h>

#include <stdexcept>
#include <string>

#include "TraceLedger.h"

namespace toss {

namespace {

/// Contributions of the boxes of one call, held by the ledgers of these boxes.
using Contributions = std::shared_ptr<std::vector<VoxelContribution>>;

struct BoxLedger {
  TrackId track = 0;
  bool dynamic = false;
  /// Those of this box: [begin, end) of `held`.
  std::size_t begin = 0, end = 0;
  Contributions held;

  ContributionSpan span() const { return {held->data() + begin, held->data() + end}; }
};

/// Spare memory that is kept: a scan is settled for each that comes.
constexpr std::size_t kSpares = 2;

ContributionSpan spanOf(const std::vector<VoxelContribution>& all) {
  return {all.data(), all.data() + all.size()};
}

}  // namespace

struct RevocableMap::Implementation {
  VoxelMap voxels;
  /// [m]
  double keepRadius;
  tsl::robin_map<BoxId, BoxLedger> boxes;
  tsl::robin_map<TrackId, TraceLedger> traces;
  /// Memory of scans whose boxes are all settled.
  std::vector<Contributions> spares;
  std::vector<ContributionSpan> spans;

  Contributions spareOrNew() {
    if (spares.empty()) return std::make_shared<std::vector<VoxelContribution>>();
    const Contributions spare = std::move(spares.back());
    spares.pop_back();
    return spare;
  }
  void erase(tsl::robin_map<BoxId, BoxLedger>::iterator place) {
    const Contributions held = std::move(place.value().held);
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

void RevocableMap::addBox(BoxId box, TrackId track, std::vector<VoxelContribution> contributions,
                          bool dynamic) {
  const auto [place, isNew] = implementation_->boxes.try_emplace(box);
  if (!isNew) throw std::logic_error("RevocableMap: box " + std::to_string(box) + " comes twice");
  if (!dynamic) implementation_->voxels.add(contributions);
  const std::size_t count = contributions.size();
  place.value() = {track, dynamic, 0, count,
                   std::make_shared<std::vector<VoxelContribution>>(std::move(contributions))};
}

void RevocableMap::addScan(BinnedReturns& binned, const std::vector<bool>& dynamic,
                           BoxId firstBox) {
  Implementation& map = *implementation_;
  const Contributions held = map.spareOrNew();
  held->swap(binned.contributions);
  map.spans.assign(1, spanOf(binned.permanent));
  for (const BinnedReturns::Owner& each : binned.owners) {
    const BoxId box = firstBox + each.owner;
    const auto [place, isNew] = map.boxes.try_emplace(box);
    if (!isNew) throw std::logic_error("RevocableMap: box " + std::to_string(box) + " comes twice");
    place.value() = {0, dynamic[each.owner], each.begin, each.end, held};
    if (!dynamic[each.owner]) map.spans.push_back(place->second.span());
  }
  map.voxels.add(map.spans);
}

void RevocableMap::addToTrack(TrackId track, const std::vector<VoxelContribution>& contributions) {
  implementation_->voxels.add(contributions);
  if (track != 0) implementation_->traces[track].add(spanOf(contributions));
}

void RevocableMap::setDynamic(BoxId box, bool dynamic) {
  BoxLedger& ledger = implementation_->find(box).value();
  if (ledger.dynamic == dynamic) return;
  ledger.dynamic = dynamic;
  if (dynamic) {
    implementation_->voxels.subtract(ledger.span());
  } else {
    implementation_->voxels.add({ledger.span()});
  }
}

void RevocableMap::fold(BoxId box) {
  const auto place = implementation_->find(box);
  const BoxLedger& ledger = place->second;
  if (!ledger.dynamic && ledger.track != 0) {
    implementation_->traces[ledger.track].add(ledger.span());
  }
  implementation_->erase(place);
}

void RevocableMap::revokeTrack(TrackId track) {
  const auto place = implementation_->traces.find(track);
  if (place == implementation_->traces.end()) return;
  implementation_->voxels.subtract(place->second.sums());
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
    bytes += (ledger.end - ledger.begin) * sizeof(VoxelContribution);
  }
  for (const auto& [track, ledger] : implementation_->traces) bytes += ledger.bytes();
  return bytes;
}

}  // namespace toss
