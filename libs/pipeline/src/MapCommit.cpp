// SPDX-License-Identifier: BSD-3-Clause
#include "MapCommit.h"

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

/// Point indices grouped by owner: those of owner o are points[begin[o]] .. points[begin[o+1]-1].
struct Grouping {
  std::vector<std::int32_t> points, begin;

  IndexSpan of(std::size_t owner) const {
    return {points.data() + begin[owner],
            static_cast<std::size_t>(begin[owner + 1] - begin[owner])};
  }
};

Grouping groupByOwner(const ScanRecord& record, const MappingOptions& options) {
  Grouping grouping;
  grouping.begin.assign(record.owners.size() + 1, 0);
  const std::size_t n = record.owner.size();
  const std::vector<bool> loneMover = record.loneMoverMarks();
  const auto belongs = [&](std::size_t i) {
    return !loneMover[i] && belongsInMap(record.pointClass[i], options);
  };
  for (std::size_t i = 0; i < n; ++i)
    if (belongs(i)) ++grouping.begin[static_cast<std::size_t>(record.owner[i]) + 1];
  for (std::size_t o = 1; o < grouping.begin.size(); ++o)
    grouping.begin[o] += grouping.begin[o - 1];
  grouping.points.resize(static_cast<std::size_t>(grouping.begin.back()));
  std::vector<std::int32_t> next(grouping.begin.begin(), grouping.begin.end() - 1);
  for (std::size_t i = 0; i < n; ++i)
    if (belongs(i)) {
      std::int32_t& slot = next[static_cast<std::size_t>(record.owner[i])];
      grouping.points[static_cast<std::size_t>(slot++)] = static_cast<std::int32_t>(i);
    }
  return grouping;
}

}  // namespace

void commitScan(const MappingOptions& options, const std::vector<bool>& movingOwners,
                ScanRecord& record, BoxId& nextLedger, StaticMap& map) {
  const Grouping grouping = groupByOwner(record, options);
  const ScanReturns returns{record.level, record.intensity, record.sensorPosition};
  map.addPermanent(returns, grouping.of(0));
  record.firstLedger = nextLedger;
  nextLedger += record.owners.size();
  for (std::size_t o = 1; o < record.owners.size(); ++o)
    map.addBox(record.firstLedger + o, record.owners[o].track, returns, grouping.of(o),
               movingOwners[o]);
  record.complete = true;
}

void previewScan(const MappingOptions& options, const std::vector<bool>& movingOwners,
                 const ScanRecord& record, StaticMap& map) {
  const Grouping grouping = groupByOwner(record, options);
  const ScanReturns returns{record.level, record.intensity, record.sensorPosition};
  for (std::size_t o = 0; o < record.owners.size(); ++o)
    if (!movingOwners[o]) map.addPermanent(returns, grouping.of(o));
}

void updateLedgers(const ScanRecord& record, const std::vector<bool>& movingOwners,
                   StaticMap& map) {
  for (std::size_t o = 1; o < record.owners.size(); ++o)
    map.setDynamic(record.firstLedger + o, movingOwners[o]);
}

void settleLedgers(const ScanRecord& record, StaticMap& map) {
  for (std::size_t o = 1; o < record.owners.size(); ++o) map.settleBox(record.firstLedger + o);
}

}  // namespace toss
