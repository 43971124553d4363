// SPDX-License-Identifier: BSD-3-Clause
#include <toss/tracking/MotionClassifier.h>

#include <algorithm>

namespace toss {
namespace {

/// Range noise of a spinning LiDAR [m]: faces scatter by that much even where none is seen.
constexpr double kRangeNoise = 0.02;

/// Auto-MOS: more than five detections, and further than the longest edge of any box of the trace.
bool movesByAutoMos(const MotionEvidence& evidence) {
  return evidence.hits() > 5 && evidence.displacement3d() > evidence.longestEdge();
}

/// Cheap necessary condition of test a, which spares most static traces the fit.
bool hasLeftItsPlace(const std::vector<TimedBox>& boxes, double demanded) {
  const Eigen::Vector3d apart = boxes.back().box.center - boxes.front().box.center;
  return apart.head<2>().norm() > 0.5 * demanded;
}

bool movesByTests(const MotionEvidence& evidence, const MotionOptions& options,
                  double jitterFactor) {
  const std::vector<TimedBox>& boxes = evidence.recent();
  if (static_cast<int>(boxes.size()) < options.minHits ||
      boxes.back().time - boxes.front().time < options.minAge ||
      evidence.medianHeight() < options.minHeight || evidence.medianExtent() < options.minExtent) {
    return false;
  }
  const double extent = options.extentFactor * evidence.medianExtent();
  const double demanded = std::max(options.minExcursion, std::min(extent, options.maxExcursion));
  if (!hasLeftItsPlace(boxes, demanded)) return false;
  const FaceMotion motion = fitFaceMotion(boxes);
  return motion.displacement > demanded &&
         motion.displacement > jitterFactor * (motion.scatter + kRangeNoise) &&
         motion.displacement >= options.minPathEfficiency * evidence.recentPathLength() &&
         motion.lagging >= options.faceShare * demanded &&
         motion.lagging >= options.faceRatio * motion.leading;
}

bool moves(const MotionEvidence& evidence, const MotionOptions& options, double jitterFactor) {
  return options.rule == MotionRule::AutoMos ? movesByAutoMos(evidence)
                                             : movesByTests(evidence, options, jitterFactor);
}

bool isHidden(const MotionEvidence& evidence, const MotionOptions& options) {
  return options.rule == MotionRule::Tests && evidence.recentHidden() > options.maxHidden;
}

bool isStrong(const MotionEvidence& evidence, const MotionOptions& options) {
  return evidence.hits() >= options.strongHits &&
         evidence.excursion() >= std::max(options.strongExtentFactor * evidence.medianExtent(),
                                          options.strongExcursion) &&
         moves(evidence, options, options.strongJitterFactor);
}

}  // namespace

MotionClass classifyMotion(const MotionEvidence& evidence, const MotionOptions& options) {
  if (!moves(evidence, options, options.doubtfulJitterFactor)) return MotionClass::Static;
  if (isHidden(evidence, options) || !moves(evidence, options, options.jitterFactor))
    return MotionClass::Doubtful;
  return isStrong(evidence, options) ? MotionClass::Strong : MotionClass::Weak;
}

}  // namespace toss
