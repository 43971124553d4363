// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/voting/DsVoting.h>

#include <algorithm>
#include <map>
#include <vector>

namespace toss::test {

/// Boxes of a log at 10 Hz, with the final class of each trace.
struct VotingScene {
  struct Box {
    double x = 0.0, y = 0.0, volume = 10.0, speed = 0.0;
  };

  std::vector<VotingBox> boxes;
  std::map<TrackId, MotionClass> classOf;

  /// Adds a box and returns its place in `boxes`.
  std::size_t add(TrackId track, int frame, const Box& box) {
    VotingBox added;
    added.scan = frame;
    added.time = 0.1 * frame;
    added.center = {box.x, box.y, 0.5};
    added.volume = box.volume;
    added.extent = 4.0;
    added.speed = box.speed;
    added.track = track;
    boxes.push_back(added);
    return boxes.size() - 1;
  }
  /// The same box in frames first..last.
  void stand(TrackId track, int first, int last, const Box& box) {
    for (int frame = first; frame <= last; ++frame) add(track, frame, box);
  }
  /// Frames first..last along x with box.speed, at box.x in frame `at`.
  void drive(TrackId track, int first, int last, int at, const Box& box) {
    for (int frame = first; frame <= last; ++frame) {
      Box moved = box;
      moved.x += 0.1 * box.speed * (frame - at);
      add(track, frame, moved);
    }
  }
  std::size_t find(TrackId track, int frame) const {
    const auto found = std::find_if(boxes.begin(), boxes.end(), [&](const VotingBox& box) {
      return box.track == track && box.scan == frame;
    });
    return static_cast<std::size_t>(found - boxes.begin());
  }

  MotionClass motion(TrackId track) const {
    const auto found = classOf.find(track);
    return found == classOf.end() ? MotionClass::Static : found->second;
  }
  std::vector<MotionClass> classes() const {
    std::vector<MotionClass> result;
    for (const VotingBox& box : boxes) result.push_back(motion(box.track));
    return result;
  }
  /// The boxes by scan, and for each its place in `boxes`.
  struct Scan {
    std::vector<VotingBox> boxes;
    std::vector<std::size_t> places;
  };
  std::map<std::int64_t, Scan> scans() const {
    std::map<std::int64_t, Scan> result;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      result[boxes[i].scan].boxes.push_back(boxes[i]);
      result[boxes[i].scan].places.push_back(i);
    }
    return result;
  }
};

}  // namespace toss::test
