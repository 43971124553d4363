// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/evaluation/ClearMot.h>
#include <toss/evaluation/EvaluationOptions.h>
#include <toss/rawlog/TracksCsv.h>

#include <cstdint>
#include <vector>

namespace toss {

/// Tracking problem of one scan from labels: objects are the moving true instances (class and
/// instance number) with at least options.trackingMinReturns returns, tracks are the instance
/// numbers of the returns called moving. Similarity is the intersection over union of their
/// annotated returns, gated by options.trackingOverlap. A track is excused where most of its
/// returns are not annotated or lie on moving objects that are too small to be asked for, and where
/// fewer than options.trackingMinReturns are left: the same rule for both sides. `truth`
/// and `called`: true and called labels, shape [n]; `ignoreUnlabelled`: whether true class 0 means
/// "not annotated".
TrackingScan trackingScanFromLabels(const std::vector<std::uint32_t>& truth,
                                    const std::vector<std::uint32_t>& called, bool ignoreUnlabelled,
                                    const EvaluationOptions& options);

/// Tracking problem of a run from boxes: moving rows of the true boxes against moving rows of
/// tracks.csv, for the scans `scans` (ascending). Similarity by options.boxMatch: 1 - distance /
/// options.boxDistance, or intersection over union gated by options.boxOverlap.
std::vector<TrackingScan> trackingScansFromBoxes(const std::vector<TrackRow>& truth,
                                                 const std::vector<TrackRow>& called,
                                                 const std::vector<std::uint64_t>& scans,
                                                 const EvaluationOptions& options);

}  // namespace toss
