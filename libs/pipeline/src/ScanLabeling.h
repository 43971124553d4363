// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "ScanRecord.h"

namespace toss {

/// Labels of a scan when `movingOwners` (shape [owners]) and the record's lone movers move, and
/// `isMovingTrack` tells which traces do.
void labelScan(const ScanRecord& record, const std::vector<bool>& movingOwners,
               const std::function<bool(TrackId)>& isMovingTrack, ScanLabels& labels);

}  // namespace toss
