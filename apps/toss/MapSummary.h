// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/rawlog/ScanSource.h>

#include "LidarSetup.h"
#include "MapOutputs.h"
#include "MapRun.h"

namespace toss {

/// Writes summary.json: version, input, counts, options (those of the first LiDAR), and the LiDARs
/// where there are several. The same run gives the same bytes.
void writeSummary(const MapRequest& request, std::vector<LidarSetup>& lidars,
                  const InputReport& input, const MapOutputs& outputs);

/// The same in a few lines for people, with the median time of each stage.
void printSummary(const MapRequest& request, const std::vector<LidarSetup>& lidars,
                  const InputReport& input, const MapOutputs& outputs);

}  // namespace toss
