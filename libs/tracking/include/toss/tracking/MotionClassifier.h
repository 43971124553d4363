// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/tracking/MotionEvidence.h>
#include <toss/tracking/MotionOptions.h>
#include <toss/tracking/Track.h>

namespace toss {

/// The coarse class that the evidence supports at this moment (spec section 6). Whoever keeps the
/// class of a trace never lowers it.
MotionClass classifyMotion(const MotionEvidence& evidence, const MotionOptions& options);

}  // namespace toss
