// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/rawlog/ScanSource.h>

#include "MapOutputs.h"
#include "MapRun.h"

namespace toss {

/// Writes summary.json: version, input, counts, options. The same run gives the same bytes.
void writeSummary(const MapRequest& request, RunConfiguration& configuration,
                  const InputReport& input, const MapOutputs& outputs);

/// The same in a few lines for people, with the median time of each stage.
void printSummary(const MapRequest& request, const InputReport& input, const MapOutputs& outputs);

}  // namespace toss
