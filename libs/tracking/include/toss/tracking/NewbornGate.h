// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/tracking/TrackingOptions.h>

namespace toss {

/// How far [m] from its first place a trace of unknown speed is looked for after `seconds` [s]
/// (spec section 5.5).
double newbornReach(const NewbornOptions& options, double seconds);

/// How far [m] from its prediction the detection that confirms a speed may lie; `step` [m] is the
/// distance that the trace should have covered since the last scan.
double confirmationReach(const NewbornOptions& options, double step);

}  // namespace toss
