// SPDX-License-Identifier: BSD-3-Clause
#include <toss/tracking/MotionClassifier.h>

#include <algorithm>

namespace toss {
namespace {

/// Range noise of a spinning LiDAR [m]: faces scatter by that much even where none is seen.
constexpr double kRangeNoise = 0.02;

/// Of the least height and extent, what a doubtful motion needs: the head behind a hedge, the few
/// returns of somebody far away.
constexpr double kDoubtfulSize = 0.5;

/// Extent over height below which a doubtful motion is none: of a wall between poles or windows one
/// sees columns that slide along it; people and what is left of them over a hedge are broader.
constexpr double kSlenderest = 0.2;

/// Auto-MOS: more than five detections, and further than the longest edge of any box of the trace.
bool movesByAutoMos(const MotionEvidence& evidence) {
  return evidence.hits() > 5 && evidence.displacement3d() > evidence.longestEdge();
}

bool reachesSize(const MotionEvidence& evidence, const MotionOptions& options, double share) {
  return evidence.medianHeight() >= share * options.minHeight &&
         evidence.medianExtent() >= share * options.minExtent;
}

/// Cheap necessary condition of test a, which spares most static traces the fit.
bool hasLeftItsPlace(const std::vector<TimedBox>& boxes, double demanded) {
  const Eigen::Vector3d apart = boxes.back().box.center - boxes.front().box.center;
  return apart.head<2>().norm() > 0.5 * demanded;
}

/// The tests of one trace's motion; what they share is found once.
class MotionTests {
 public:
  MotionTests(const MotionEvidence& evidence, const MotionOptions& options)
      : byTests_(options.rule != MotionRule::AutoMos),
        moves_(byTests_ ? movesByFaces(evidence, options) : movesByAutoMos(evidence)) {}

  /// Whether the trace moves by more than its jitter times the factor.
  bool moves(double jitterFactor) const {
    return moves_ &&
           (!byTests_ || motion_.displacement > jitterFactor * (motion_.scatter + kRangeNoise));
  }

 private:
  /// All tests but that of jitter.
  bool movesByFaces(const MotionEvidence& evidence, const MotionOptions& options) {
    const std::vector<TimedBox>& boxes = evidence.recent();
    if (static_cast<int>(boxes.size()) < options.minHits ||
        boxes.back().time - boxes.front().time < options.minAge ||
        !reachesSize(evidence, options, kDoubtfulSize)) {
      return false;
    }
    const double extent = options.extentFactor * evidence.medianExtent();
    const double demanded = std::max(options.minExcursion, std::min(extent, options.maxExcursion));
    if (!hasLeftItsPlace(boxes, demanded)) return false;
    motion_ = fitFaceMotion(boxes);
    return motion_.displacement > demanded &&
           motion_.displacement >= options.minPathEfficiency * evidence.recentPathLength() &&
           motion_.lagging >= options.faceShare * demanded &&
           motion_.lagging >= options.faceRatio * motion_.leading;
  }

  FaceMotion motion_;
  bool byTests_, moves_;
};

bool isHidden(const MotionEvidence& evidence, const MotionOptions& options) {
  return options.rule == MotionRule::Tests && evidence.recentHidden() > options.maxHidden;
}

bool isSmall(const MotionEvidence& evidence, const MotionOptions& options) {
  return options.rule == MotionRule::Tests && !reachesSize(evidence, options, 1.0);
}

bool isColumn(const MotionEvidence& evidence) {
  return evidence.medianExtent() < kSlenderest * evidence.medianHeight();
}

bool isStrong(const MotionEvidence& evidence, const MotionOptions& options,
              const MotionTests& tests) {
  return evidence.hits() >= options.strongHits &&
         evidence.excursion() >= std::max(options.strongExtentFactor * evidence.medianExtent(),
                                          options.strongExcursion) &&
         tests.moves(options.strongJitterFactor);
}

}  // namespace

MotionClass classifyMotion(const MotionEvidence& evidence, const MotionOptions& options) {
  const MotionTests tests(evidence, options);
  if (!tests.moves(options.doubtfulJitterFactor)) return MotionClass::Static;
  if (isHidden(evidence, options) || isSmall(evidence, options) ||
      !tests.moves(options.jitterFactor))
    return isColumn(evidence) ? MotionClass::Static : MotionClass::Doubtful;
  return isStrong(evidence, options, tests) ? MotionClass::Strong : MotionClass::Weak;
}

}  // namespace toss
