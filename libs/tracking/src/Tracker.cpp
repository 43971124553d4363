// SPDX-License-Identifier: BSD-3-Clause
#include <toss/tracking/Association.h>
#include <toss/tracking/AssociationCost.h>
#include <toss/tracking/MotionClassifier.h>
#include <toss/tracking/NewbornGate.h>
#include <toss/tracking/TrackLifecycle.h>
#include <toss/tracking/Tracker.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "TrackState.h"

namespace toss {
namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

/// Order of detections that does not depend on how they were numbered.
bool comesBefore(const Box& a, const Box& b) {
  const auto key = [](const Box& box) {
    return std::make_tuple(box.center.x(), box.center.y(), box.center.z(), box.length, box.width,
                           box.height, box.yaw);
  };
  return key(a) < key(b);
}

}  // namespace

struct Tracker::Implementation {
  Implementation(const TrackingOptions& trackingOptions, const MotionOptions& motionOptions,
                 std::shared_ptr<TrackId> lastTrack)
      : tracking(trackingOptions),
        motion(motionOptions),
        lastId(lastTrack ? std::move(lastTrack) : std::make_shared<TrackId>(0)) {
    tracking.check();
    motion.check();
  }

  void update(double now, const std::vector<Detection>& scan);

  void startScan(double now, const std::vector<Detection>& scan);
  void associateAll();
  void associateNewborn();
  /// Associates detections that have no trace yet with open traces that `wanted` picks; returns the
  /// states that got a detection.
  template <typename Wanted, typename Reach>
  std::vector<std::size_t> associateOpen(const AssociationGates& gates, const Wanted& wanted,
                                         const Reach& reach);
  double usualReach(const TrackState& state) const;
  void takeDetections();
  void takeDetection(TrackState& state, std::size_t detection);
  void showEstimate(TrackState& state);
  void observeMotion(TrackState& state, const Detection& detection);
  void endTracks();
  void startTracks();
  void startTrack(std::size_t detection);
  void publish();

  TrackingOptions tracking;
  MotionOptions motion;

  double time = -std::numeric_limits<double>::infinity();
  double seconds = 0.0;
  KalmanNoise noise;
  std::shared_ptr<TrackId> lastId;
  std::vector<TrackState> states;

  const std::vector<Detection>* detections = nullptr;
  /// Detections that may have a trace, in an order of their own.
  std::vector<std::size_t> usable;
  std::vector<std::size_t> detectionOfState, stateOfDetection;

  std::vector<TrackId> trackOfDetection;
  std::vector<Track> tracks, ended;
};

void Tracker::Implementation::update(double now, const std::vector<Detection>& scan) {
  startScan(now, scan);
  associateAll();
  associateNewborn();
  takeDetections();
  endTracks();
  startTracks();
  publish();
}

void Tracker::Implementation::startScan(double now, const std::vector<Detection>& scan) {
  if (!(now > time)) throw std::logic_error("Tracker::update: time must grow from scan to scan");
  seconds = std::isfinite(time) ? now - time : 0.0;
  time = now;
  noise = kalmanNoise(tracking.kalman, seconds);
  detections = &scan;
  usable.clear();
  for (std::size_t i = 0; i < scan.size(); ++i) {
    if (mayContinueTrack(scan[i], tracking.lifecycle)) usable.push_back(i);
  }
  std::stable_sort(usable.begin(), usable.end(), [&](std::size_t a, std::size_t b) {
    return comesBefore(scan[a].box, scan[b].box);
  });
  for (TrackState& state : states) state.filter.predict(noise);
  detectionOfState.assign(states.size(), kNone);
  stateOfDetection.assign(scan.size(), kNone);
  trackOfDetection.assign(scan.size(), 0);
}

void Tracker::Implementation::associateAll() {
  const AssociationOptions& options = tracking.association;
  associateOpen(
      {options.minOverlap, options.maxVolumeCost, 0.0}, [](const TrackState&) { return true; },
      [this](const TrackState& state) { return usualReach(state); });
}

void Tracker::Implementation::associateNewborn() {
  if (!tracking.newborn.enabled) return;
  const double reach = newbornReach(tracking.newborn, seconds);
  const auto seenOnceJustNow = [](const TrackState& state) {
    return state.track.hits == 1 && state.track.misses == 0;
  };
  const auto found =
      associateOpen({0.0, tracking.association.maxVolumeCost, tracking.newborn.minSideRatio},
                    seenOnceJustNow, [reach](const TrackState&) { return reach; });
  for (const std::size_t j : found) states[j].awaitsConfirmation = true;
}

double Tracker::Implementation::usualReach(const TrackState& state) const {
  const AssociationOptions& options = tracking.association;
  if (state.awaitsConfirmation) {
    return confirmationReach(tracking.newborn, noise.step * state.filter.velocity().norm());
  }
  if (state.track.hits < 2) return options.maxDistance;
  const double innovationVariance = state.filter.positionVariance() + noise.measuredPosition;
  const double reach = options.innovationFactor * std::sqrt(2.0 * innovationVariance);
  return std::max(options.maxDistance, std::min(reach, options.maxGate));
}

template <typename Wanted, typename Reach>
std::vector<std::size_t> Tracker::Implementation::associateOpen(const AssociationGates& gates,
                                                                const Wanted& wanted,
                                                                const Reach& reach) {
  const double minExtent = tracking.association.minExtent;
  AssociationProblem problem;
  problem.gates = gates;
  std::vector<std::size_t> openDetections, openStates;
  problem.detections.reserve(usable.size()), problem.targets.reserve(states.size());
  openDetections.reserve(usable.size()), openStates.reserve(states.size());
  for (const std::size_t i : usable) {
    if (stateOfDetection[i] != kNone) continue;
    openDetections.push_back(i);
    problem.detections.push_back(withMinExtent((*detections)[i].box, minExtent));
  }
  for (std::size_t j = 0; j < states.size(); ++j) {
    if (detectionOfState[j] != kNone || !wanted(states[j])) continue;
    openStates.push_back(j);
    problem.targets.push_back({withMinExtent(states[j].filter.box(), minExtent), reach(states[j])});
  }
  std::vector<std::size_t> found;
  for (const AssociationPair& pair : associate(problem, tracking.association)) {
    const std::size_t detection = openDetections[static_cast<std::size_t>(pair.detection)];
    const std::size_t state = openStates[static_cast<std::size_t>(pair.target)];
    detectionOfState[state] = detection;
    stateOfDetection[detection] = state;
    found.push_back(state);
  }
  return found;
}

void Tracker::Implementation::takeDetections() {
  for (std::size_t j = 0; j < states.size(); ++j) {
    Track& track = states[j].track;
    if (detectionOfState[j] != kNone) {
      takeDetection(states[j], detectionOfState[j]);
    } else {
      track.detection = -1;
      ++track.misses;
      ++track.totalMisses;
    }
    showEstimate(states[j]);
  }
}

void Tracker::Implementation::showEstimate(TrackState& state) {
  const double stepsPerSecond = seconds > 0.0 ? noise.step / seconds : 1.0;
  state.track.time = time;
  state.track.box = state.filter.box();
  state.track.velocity = stepsPerSecond * state.filter.velocity();
}

void Tracker::Implementation::takeDetection(TrackState& state, std::size_t detection) {
  const Box& measured = (*detections)[detection].box;
  Track& track = state.track;
  if (track.hits > 1) state.awaitsConfirmation = false;
  state.filter.update(measured, noise);
  track.detection = static_cast<std::int32_t>(detection);
  ++track.hits;
  track.misses = 0;
  track.confirmed = track.hits >= tracking.lifecycle.minHits;
  trackOfDetection[detection] = track.id;
  observeMotion(state, (*detections)[detection]);
}

void Tracker::Implementation::observeMotion(TrackState& state, const Detection& detection) {
  const double hidden = 0.5 * (static_cast<double>(detection.occludedLeft) +
                               static_cast<double>(detection.occludedRight));
  state.evidence.add({time, state.filter.box(), detection.box, hidden});
  Track& track = state.track;
  if (track.motion != MotionClass::Strong) {
    track.motion = std::max(track.motion, classifyMotion(state.evidence, motion));
  }
  track.excursion = state.evidence.excursion();
  track.pathLength = state.evidence.pathLength();
  track.medianExtent = state.evidence.medianExtent();
}

void Tracker::Implementation::endTracks() {
  ended.clear();
  const auto lost = [this](const TrackState& state) {
    const bool refuted = state.awaitsConfirmation && !state.track.updated();
    return refuted || hasEnded(state.track, tracking.lifecycle);
  };
  for (const TrackState& state : states) {
    if (lost(state)) ended.push_back(state.track);
  }
  states.erase(std::remove_if(states.begin(), states.end(), lost), states.end());
}

void Tracker::Implementation::startTracks() {
  for (const std::size_t i : usable) {
    if (stateOfDetection[i] == kNone && mayStartTrack((*detections)[i], tracking.lifecycle)) {
      startTrack(i);
    }
  }
}

void Tracker::Implementation::startTrack(std::size_t detection) {
  const Box& measured = (*detections)[detection].box;
  TrackState state{{}, KalmanFilter(measured, noise), MotionEvidence(motion.window)};
  state.track.id = ++*lastId;
  state.track.birthTime = time;
  state.track.detection = static_cast<std::int32_t>(detection);
  state.track.hits = 1;
  state.track.confirmed = tracking.lifecycle.minHits <= 1;
  trackOfDetection[detection] = state.track.id;
  observeMotion(state, (*detections)[detection]);
  showEstimate(state);
  states.push_back(std::move(state));
}

void Tracker::Implementation::publish() {
  tracks.clear();
  for (const TrackState& state : states) tracks.push_back(state.track);
}

Tracker::Tracker(const TrackingOptions& tracking, const MotionOptions& motion,
                 std::shared_ptr<TrackId> lastId)
    : implementation_(std::make_unique<Implementation>(tracking, motion, std::move(lastId))) {}

Tracker::~Tracker() = default;

void Tracker::update(double time, const std::vector<Detection>& detections) {
  implementation_->update(time, detections);
}

const std::vector<TrackId>& Tracker::trackOfDetection() const {
  return implementation_->trackOfDetection;
}

const std::vector<Track>& Tracker::tracks() const {
  return implementation_->tracks;
}

const std::vector<Track>& Tracker::ended() const {
  return implementation_->ended;
}

}  // namespace toss
