// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/mapping/StaticMap.h>

#include "ClaimFinder.h"
#include "ScanRecord.h"

namespace toss {

/// Enters the returns of a scan into the static map once all views have testified: each owner's
/// under a ledger of its own, what nobody owns for good. Sets record.firstLedger from `nextLedger`;
/// the record's coordinates are needed no more.
void commitScan(const MappingOptions& options, const std::vector<bool>& movingOwners,
                ScanRecord& record, BoxId& nextLedger, StaticMap& map);

/// What of a scan stays whose labels are final, for StaticMap::addDecided(). Valid until the next
/// call of the thread; the record's coordinates are needed no more when `map` has taken it.
StaticMap::DecidedScan decidedScan(const MappingOptions& options,
                                   const std::vector<bool>& movingOwners, const StaticMap& map,
                                   ScanRecord& record);

/// Enters the returns of a scan that is not complete, without those of moving owners and those
/// that are claimed. Counts `nextLedger` up.
void previewScan(const MappingOptions& options, const std::vector<bool>& movingOwners,
                 const std::vector<Claim>& claims, const ScanRecord& record, BoxId& nextLedger,
                 StaticMap& map);

/// Gives every ledger of a committed scan its owner's present label.
void updateLedgers(const ScanRecord& record, const std::vector<bool>& movingOwners, StaticMap& map);

/// Adds to the record's lone movers the residue of moving owners in whose places, `placeSize` [m]
/// large, nothing static is left in the map: all that was ever measured there was measured while
/// something stood there that moves. All of it where the size is 0.
void releaseResidue(double placeSize, const std::vector<bool>& movingOwners, StaticMap& map,
                    ScanRecord& record);

/// Makes the labels of all ledgers of a committed scan final.
void settleLedgers(const ScanRecord& record, StaticMap& map);

}  // namespace toss
