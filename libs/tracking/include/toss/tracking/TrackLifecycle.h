// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/tracking/Detection.h>
#include <toss/tracking/Track.h>
#include <toss/tracking/TrackingOptions.h>

namespace toss {

/// Whether a detection may continue a trace: finite, no background, enough returns.
bool mayContinueTrack(const Detection& detection, const LifecycleOptions& options);

/// Whether a detection that continues no trace starts one.
bool mayStartTrack(const Detection& detection, const LifecycleOptions& options);

/// Whether the trace has been missed for good.
bool hasEnded(const Track& track, const LifecycleOptions& options);

}  // namespace toss
