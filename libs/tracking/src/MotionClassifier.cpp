// SPDX-License-Identifier: BSD-3-Clause
#include <toss/tracking/MotionClassifier.h>

#include <algorithm>

namespace toss {
namespace {

/// Auto-MOS: more than five detections, and further than the longest edge of any box of the trace.
bool movesByAutoMos(const MotionEvidence& evidence) {
  return evidence.hits() > 5 && evidence.displacement3d() > evidence.longestEdge();
}

bool movesByTests(const MotionEvidence& evidence, const MotionOptions& options) {
  if (evidence.hits() < options.minHits || evidence.age() < options.minAge) return false;
  const double demanded = std::clamp(options.extentFactor * evidence.medianExtent(),
                                     options.minExcursion, options.maxExcursion);
  return evidence.excursion() > demanded &&
         evidence.excursion() > options.jitterFactor * evidence.jitter() &&
         evidence.excursion() >= options.minPathEfficiency * evidence.pathLength() &&
         evidence.faceDisplacement() >= options.faceShare * demanded;
}

bool isStrong(const MotionEvidence& evidence, const MotionOptions& options) {
  return evidence.hits() >= options.strongHits &&
         evidence.excursion() >= std::max(options.strongExtentFactor * evidence.medianExtent(),
                                          options.strongExcursion);
}

}  // namespace

MotionClass classifyMotion(const MotionEvidence& evidence, const MotionOptions& options) {
  const bool moves = options.rule == MotionRule::AutoMos ? movesByAutoMos(evidence)
                                                         : movesByTests(evidence, options);
  if (!moves) return MotionClass::Static;
  return isStrong(evidence, options) ? MotionClass::Strong : MotionClass::Weak;
}

}  // namespace toss
