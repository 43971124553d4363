// SPDX-License-Identifier: BSD-3-Clause
#include <toss/odometry/PoseJudgement.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "FrameAlignment.h"

namespace toss {
namespace {

/// Motions are compared over this time [s].
constexpr double kSpan = 0.5;
/// Errors that are none: as a good odometry and good poses have them [m], and as a share of the
/// motion.
constexpr double kNoise = 0.1, kNoiseShare = 0.05;
/// Less motion than this tells nothing [m].
constexpr double kLeastMotion = 0.3;
/// A cause must leave at most this share of the error.
constexpr double kExplained = 0.5;
/// Share of the found poses' fit from which on poses are right.
constexpr double kSharpEnough = 0.97;
/// How far a camera that looks ahead is turned against the LiDAR at most [rad].
constexpr double kCameraMounting = 0.2;
constexpr double kLongestOffset = 1.0, kOffsetStep = 0.02;

using Poses = std::vector<Eigen::Isometry3d>;

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double medianError(const std::vector<MotionPair>& pairs) {
  std::vector<double> errors;
  for (const MotionPair& pair : pairs) errors.push_back(reach(pair.given.inverse() * pair.found));
  return errors.empty() ? 0.0 : median(errors);
}

double medianMotion(const std::vector<MotionPair>& pairs,
                    const std::function<Eigen::Isometry3d(const MotionPair&)>& of) {
  std::vector<double> motions;
  for (const MotionPair& pair : pairs) motions.push_back(reach(of(pair)));
  return motions.empty() ? 0.0 : median(motions);
}

/// Pose of the stretch at a time between its ends.
Eigen::Isometry3d givenAt(const MotionStretch& stretch, double time) {
  const auto after = std::lower_bound(stretch.times.begin(), stretch.times.end(), time);
  const auto i = static_cast<std::size_t>(after - stretch.times.begin());
  if (i == 0) return stretch.given.front();
  const double share = (time - stretch.times[i - 1]) / (stretch.times[i] - stretch.times[i - 1]);
  const Eigen::Isometry3d step = stretch.given[i - 1].inverse() * stretch.given[i];
  Eigen::Isometry3d part = Eigen::Isometry3d::Identity();
  part.linear() = Eigen::Quaterniond::Identity()
                      .slerp(share, Eigen::Quaterniond(step.linear()))
                      .toRotationMatrix();
  part.translation() = share * step.translation();
  return stretch.given[i - 1] * part;
}

/// Motions over kSpan, the given ones `offset` later. `margin` [s]: what is left out at both ends,
/// so that all offsets up to it have the same pairs.
std::vector<MotionPair> pairsOf(const std::vector<MotionStretch>& stretches, double offset,
                                double margin) {
  std::vector<MotionPair> pairs;
  for (const MotionStretch& stretch : stretches) {
    const std::vector<double>& times = stretch.times;
    for (std::size_t i = 0, j = 0; i < times.size(); ++i) {
      while (j < times.size() && times[j] < times[i] + kSpan - 1e-3) ++j;
      if (j == times.size() || times[j] > times.back() - margin) break;
      if (times[i] < times.front() + margin || times[j] > times[i] + 2.0 * kSpan) continue;
      const Eigen::Isometry3d from = givenAt(stretch, times[i] + offset);
      pairs.push_back({from.inverse() * givenAt(stretch, times[j] + offset),
                       stretch.found[i].inverse() * stretch.found[j]});
    }
  }
  return pairs;
}

/// The pairs as they would be if the given motions were other ones.
std::vector<MotionPair> changed(
    std::vector<MotionPair> pairs,
    const std::function<Eigen::Isometry3d(const Eigen::Isometry3d&)>& change) {
  for (MotionPair& pair : pairs) pair.given = change(pair.given);
  return pairs;
}

std::vector<MotionStretch> inverted(std::vector<MotionStretch> stretches) {
  for (MotionStretch& stretch : stretches)
    for (Eigen::Isometry3d& pose : stretch.given) pose = pose.inverse();
  return stretches;
}

double scaleOf(const std::vector<MotionPair>& pairs) {
  std::vector<double> ratios;
  for (const MotionPair& pair : pairs)
    if (pair.given.translation().norm() > 1e-6)
      ratios.push_back(pair.found.translation().norm() / pair.given.translation().norm());
  return ratios.empty() ? 1.0 : median(ratios);
}

/// Collects the causes that explain the error, the best of them last; simple ones come first and
/// give way only to clearly better ones.
class Explanation {
 public:
  explicit Explanation(PoseJudgement& judgement)
      : judgement_(judgement), best_(kExplained * judgement.error) {}

  /// Whether this fault, which leaves `error`, is the best explanation up to now.
  bool offer(PoseFault fault, double error) {
    const double share = judgement_.fault == PoseFault::Inconsistent ? 1.0 : 0.7;
    if (error >= share * best_) return false;
    judgement_.fault = fault;
    judgement_.mendedError = best_ = error;
    return true;
  }

 private:
  PoseJudgement& judgement_;
  double best_;
};

void offerOffset(const std::vector<MotionStretch>& stretches, Explanation& explanation,
                 PoseJudgement& judgement) {
  const double unshifted = medianError(pairsOf(stretches, 0.0, kLongestOffset));
  double best = unshifted, offset = 0.0;
  for (int step = -50; step <= 50; ++step) {
    const double error = medianError(pairsOf(stretches, step * kOffsetStep, kLongestOffset));
    if (error < best) best = error, offset = step * kOffsetStep;
  }
  if (best < kExplained * unshifted && explanation.offer(PoseFault::TimeOffset, best))
    judgement.timeOffset = offset;
}

void explain(const std::vector<MotionStretch>& stretches, const std::vector<MotionPair>& pairs,
             PoseJudgement& judgement) {
  judgement.fault = PoseFault::Inconsistent;
  Explanation explanation(judgement);
  explanation.offer(PoseFault::Inverted, medianError(pairsOf(inverted(stretches), 0.0, 0.0)));
  const auto turnedBy = [](const Eigen::Isometry3d& frame) {
    return [frame](const Eigen::Isometry3d& given) { return frame.inverse() * given * frame; };
  };
  explanation.offer(PoseFault::CameraAxes,
                    medianError(changed(pairs, turnedBy(cameraAxesFromLidar()))));
  const double scale = scaleOf(pairs);
  const auto scaled = [scale](Eigen::Isometry3d given) {
    given.translation() *= scale;
    return given;
  };
  if (explanation.offer(PoseFault::Scale, medianError(changed(pairs, scaled))))
    judgement.scale = scale;
  offerOffset(stretches, explanation, judgement);
  const Eigen::Isometry3d frame = poseFrameFromSensor(pairs);
  if (!explanation.offer(PoseFault::Displaced, medianError(changed(pairs, turnedBy(frame)))))
    return;
  judgement.poseFromSensor = frame;
  const Eigen::Matrix3d turn = frame.linear().transpose() * cameraAxesFromLidar().linear();
  if (Eigen::AngleAxisd(turn).angle() < kCameraMounting) judgement.fault = PoseFault::CameraAxes;
}

double fitShareOf(const std::vector<MotionStretch>& stretches) {
  double given = 0.0, found = 0.0;
  for (const MotionStretch& stretch : stretches)
    given += stretch.givenFit, found += stretch.foundFit;
  return found > 0.0 ? given / found : 0.0;
}

}  // namespace

PoseJudgement judgePoses(const std::vector<MotionStretch>& stretches) {
  PoseJudgement judgement;
  const std::vector<MotionPair> pairs = pairsOf(stretches, 0.0, 0.0);
  judgement.error = judgement.mendedError = medianError(pairs);
  judgement.motion = medianMotion(pairs, [](const MotionPair& pair) { return pair.found; });
  const double givenMotion = medianMotion(pairs, [](const MotionPair& pair) { return pair.given; });
  if (std::max(judgement.motion, givenMotion) < kLeastMotion) return judgement;
  judgement.fitShare = fitShareOf(stretches);
  if (judgement.error < kNoise + kNoiseShare * judgement.motion ||
      judgement.fitShare > kSharpEnough)
    judgement.fault = PoseFault::None;
  else if (givenMotion < 0.1 * judgement.motion)
    judgement.fault = PoseFault::Still;
  else
    explain(stretches, pairs, judgement);
  return judgement;
}

}  // namespace toss
