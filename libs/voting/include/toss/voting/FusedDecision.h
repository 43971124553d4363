// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/tracking/Track.h>
#include <toss/visibility/EvidenceCells.h>
#include <toss/voting/DecisionOptions.h>

namespace toss {

/// Class of a trace from how it moved and from what other scans saw where it was: free space alone
/// makes it Strong, a clear hit record makes it Static, some of it confirms a Weak motion as
/// Strong, glimpses past it confirm a Doubtful one, else motion decides (spec section 12).
/// `whileFast`: the evidence of the scans in which it would soon have left its place, empty where
/// none is known. What is measured there again all the same is the visible part of a wall or rail
/// that slides along with the sensor, and Static too.
MotionClass fuseTrace(MotionClass motion, const FreeSpaceSum& evidence,
                      const FreeSpaceSum& whileFast, const DecisionOptions& options);

/// Verdict on one instance: `voted` is DS-Voting's label, `trace` the fused class of its trace, and
/// `evidence` what views say about the instance alone. True = moving.
bool fuseInstance(bool voted, MotionClass trace, const FreeSpaceSum& evidence,
                  const DecisionOptions& options);

/// Whether a trace that was seen in `scans` scans is known well enough to say where it is when it
/// is not seen.
bool isWellKnown(int scans, const FreeSpaceSum& evidence, const DecisionOptions& options);

}  // namespace toss
