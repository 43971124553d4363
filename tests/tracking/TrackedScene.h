// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/tracking/Tracker.h>

#include <functional>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace toss {

/// Box with the given centre and extents [m], standing on z = 0.
inline Box standingBox(double x, double y, double length, double width, double height = 1.5) {
  Box box;
  box.center = {x, y, 0.5 * height};
  box.length = length, box.width = width, box.height = height;
  return box;
}

inline Detection detectionOf(const Box& box, int pointCount = 100) {
  Detection detection;
  detection.box = box;
  detection.pointCount = pointCount;
  return detection;
}

/// Measures one face of the box anew: what a LiDAR sees of a box jitters by its beam spacing.
inline Box jittered(Box box, double sd, std::mt19937& random) {
  std::normal_distribution<double> jitter(0.0, sd);
  box.center += Eigen::Vector3d(jitter(random), jitter(random), jitter(random));
  box.length = std::max(0.02, box.length + jitter(random));
  box.width = std::max(0.02, box.width + jitter(random));
  return box;
}

/// Objects with known paths, shown to a tracker scan by scan; remembers which traces each had.
class TrackedScene {
 public:
  /// The box of an object at a time [s].
  using Path = std::function<Box(double)>;

  explicit TrackedScene(const TrackingOptions& tracking = {}, const MotionOptions& motion = {})
      : tracker(tracking, motion) {}

  void add(Path path) {
    paths_.push_back(std::move(path));
    ids_.emplace_back();
  }

  /// Shows the objects for `seconds` at `rate` [scans/s].
  void run(double seconds, double rate = 10.0) {
    for (double end = time_ + seconds - 1e-9; time_ < end; time_ += 1.0 / rate) {
      std::vector<Detection> detections;
      for (const Path& path : paths_) detections.push_back(detectionOf(path(time_)));
      show(detections);
    }
  }

  /// Traces that object `index` had, without 0.
  const std::set<TrackId>& ids(std::size_t index) const { return ids_[index]; }

  /// Highest class that any trace of the object had.
  MotionClass motionOf(std::size_t index) const {
    MotionClass motion = MotionClass::Static;
    for (const TrackId id : ids_[index]) motion = std::max(motion, last_.at(id).motion);
    return motion;
  }

  /// The last state of a trace.
  const Track& last(TrackId id) const { return last_.at(id); }
  double time() const { return time_; }

  Tracker tracker;

 private:
  void show(const std::vector<Detection>& detections) {
    tracker.update(time_, detections);
    for (std::size_t i = 0; i < detections.size(); ++i) {
      if (const TrackId id = tracker.trackOfDetection()[i]) ids_[i].insert(id);
    }
    for (const Track& track : tracker.tracks()) last_[track.id] = track;
    for (const Track& track : tracker.ended()) last_[track.id] = track;
  }

  std::vector<Path> paths_;
  std::vector<std::set<TrackId>> ids_;
  std::map<TrackId, Track> last_;
  double time_ = 0.0;
};

}  // namespace toss
