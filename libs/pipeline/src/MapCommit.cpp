// SPDX-License-Identifier: BSD-3-Clause
#include "MapCommit.h"

#include <algorithm>
#include <array>

namespace toss {
namespace {

bool belongsInMap(PointClass pointClass, const MappingOptions& options) {
  switch (pointClass) {
    case PointClass::Invalid:
      return false;
    case PointClass::BelowGround:
      return options.keepBelowGround;
    case PointClass::OutOfRange:
      return options.farPoints == FarPoints::KeepStatic;
    default:
      return true;
  }
}

/// Owner of each return that goes into the map, below 0 for the others. Valid until the next call
/// of the thread.
std::vector<std::int32_t>& ownersInMap(const MappingOptions& options, const ScanRecord& record) {
  // All bits where returns of a class are not kept.
  constexpr std::size_t kClasses = 256;
  std::array<std::int32_t, kClasses> left;
  for (std::size_t c = 0; c < kClasses; ++c)
    left[c] = belongsInMap(static_cast<PointClass>(c), options) ? 0 : -1;
  thread_local std::vector<std::int32_t> owners;
  owners.resize(record.owner.size());
  for (std::size_t i = 0; i < owners.size(); ++i)
    owners[i] = record.owner[i] | left[static_cast<std::size_t>(record.pointClass[i])];
  for (const std::int32_t point : record.loneMovers) owners[static_cast<std::size_t>(point)] = -1;
  return owners;
}

/// Owners that have returns in the map.
void markMapped(const std::vector<std::int32_t>& ownersInMap, std::vector<Owner>& owners) {
  std::vector<std::uint8_t> mapped(owners.size() + 1, 0);
  // The first place is of returns that are left out.
  for (const std::int32_t owner : ownersInMap) mapped[static_cast<std::size_t>(owner + 1)] = 1;
  for (std::size_t o = 1; o < owners.size(); ++o) owners[o].mapped = mapped[o + 1] != 0;
}

/// Leaves out the returns of moving owners.
void leaveMovers(const std::vector<bool>& movingOwners, std::vector<std::int32_t>& ownersInMap) {
  // All bits where an owner moves; the first place is of returns that are left out anyway.
  std::vector<std::int32_t> left(movingOwners.size() + 1, -1);
  for (std::size_t o = 0; o < movingOwners.size(); ++o) left[o + 1] = movingOwners[o] ? -1 : 0;
  for (std::int32_t& owner : ownersInMap) owner |= left[static_cast<std::size_t>(owner + 1)];
}

ScanReturns returnsOf(const ScanRecord& record) {
  return {record.level, record.intensity, record.sensorPosition};
}

/// The record's coordinates are needed no more.
void complete(const StaticMap& map, ScanRecord& record) {
  const ScanPlaces places = map.placesOf(returnsOf(record));
  record.residuePlace.clear();
  record.residuePlace.reserve(record.residue.size());
  for (const std::int32_t point : record.residue)
    record.residuePlace.push_back(places.of(static_cast<std::size_t>(point)));
  record.complete = true;
}

}  // namespace

void commitScan(const MappingOptions& options, const std::vector<bool>& movingOwners,
                ScanRecord& record, BoxId& nextLedger, StaticMap& map) {
  const std::vector<std::int32_t>& owners = ownersInMap(options, record);
  markMapped(owners, record.owners);
  record.firstLedger = nextLedger;
  nextLedger += record.owners.size();
  map.addScan(returnsOf(record), owners, movingOwners, record.firstLedger);
  complete(map, record);
}

StaticMap::DecidedScan decidedScan(const MappingOptions& options,
                                   const std::vector<bool>& movingOwners, const StaticMap& map,
                                   ScanRecord& record) {
  std::vector<std::int32_t>& owners = ownersInMap(options, record);
  leaveMovers(movingOwners, owners);
  complete(map, record);
  return {returnsOf(record), owners};
}

void previewScan(const MappingOptions& options, const std::vector<bool>& movingOwners,
                 const std::vector<Claim>& claims, const ScanRecord& record, BoxId& nextLedger,
                 StaticMap& map) {
  std::vector<std::int32_t>& owners = ownersInMap(options, record);
  for (const Claim& claim : claims) owners[static_cast<std::size_t>(claim.point)] = -1;
  map.addScan(returnsOf(record), owners, movingOwners, nextLedger);
  nextLedger += record.owners.size();
}

void updateLedgers(const ScanRecord& record, const std::vector<bool>& movingOwners,
                   StaticMap& map) {
  for (std::size_t o = 1; o < record.owners.size(); ++o)
    if (record.owners[o].mapped) map.setDynamic(record.firstLedger + o, movingOwners[o]);
}

void releaseResidue(double placeSize, const std::vector<bool>& movingOwners, StaticMap& map,
                    ScanRecord& record) {
  const auto isHeld = [&](VoxelKey voxel) {
    return placeSize > 0.0 && map.holds(voxel, placeSize);
  };
  for (std::size_t r = 0; r < record.residue.size(); ++r) {
    const std::int32_t point = record.residue[r];
    const auto o = static_cast<std::size_t>(record.owner[static_cast<std::size_t>(point)]);
    const auto host = static_cast<std::size_t>(record.owners[o].host);
    if (movingOwners[o] && !movingOwners[host] && !isHeld(record.residuePlace[r]))
      record.loneMovers.push_back(point);
  }
  std::sort(record.loneMovers.begin(), record.loneMovers.end());
}

void settleLedgers(const ScanRecord& record, StaticMap& map) {
  for (std::size_t o = 1; o < record.owners.size(); ++o)
    if (record.owners[o].mapped) map.settleBox(record.firstLedger + o);
}

}  // namespace toss
