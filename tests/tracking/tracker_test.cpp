// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <toss/geometry/Error.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "TrackedScene.h"

namespace toss {
namespace {

/// A busy place: walkers, cars and standing things, some of them unseen in some scans.
std::vector<Detection> busyScan(double time, std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<Detection> scan;
  for (int i = 0; i < 60; ++i) {
    const double x = (i % 3 == 0 ? 1.3 : i % 3 == 1 ? 9.0 : 0.0) * time * (i % 2 == 0 ? 1 : -1);
    const Box box =
        i % 3 == 1 ? standingBox(x, 5.0 * i, 4.2, 1.8) : standingBox(x, 5.0 * i, 0.5, 0.6);
    const Box seen = jittered(box, 0.05, random);
    if (unit(random) < 0.9) scan.push_back(detectionOf(seen));
  }
  return scan;
}

/// Everything that a run gives, for comparisons to the bit.
std::string report(const Tracker& tracker) {
  std::string text;
  for (const Track& track : tracker.tracks()) {
    text += std::to_string(track.id) + " " + std::to_string(static_cast<int>(track.motion));
    for (const double value : {track.box.center.x(), track.box.center.y(), track.box.length,
                               track.velocity.x(), track.excursion, track.pathLength}) {
      text.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
  }
  return text;
}

TEST(Tracker, GivesTheSameBytesEveryTimeAndForEveryOrderOfTheDetections) {
  std::mt19937 random(9), again(9), shuffled(9), order(1);
  Tracker first(TrackingOptions{}), second(TrackingOptions{}), third(TrackingOptions{});
  for (int scan = 0; scan < 60; ++scan) {
    const double time = 0.1 * scan;
    first.update(time, busyScan(time, random));
    second.update(time, busyScan(time, again));
    std::vector<Detection> detections = busyScan(time, shuffled);
    std::shuffle(detections.begin(), detections.end(), order);
    third.update(time, detections);
    ASSERT_EQ(report(first), report(second));
    ASSERT_EQ(report(first), report(third));
  }
  EXPECT_GT(first.tracks().size(), 50u);
}

TEST(Tracker, NeverReusesAnId) {
  std::mt19937 random(10);
  std::uniform_real_distribution<double> place(-50.0, 50.0);
  Tracker tracker(TrackingOptions{});
  std::set<TrackId> alive, dead;
  TrackId newest = 0;
  for (int scan = 0; scan < 200; ++scan) {
    std::vector<Detection> detections;
    for (int i = 0; i < 20; ++i) {
      detections.push_back(detectionOf(standingBox(place(random), place(random), 1.0, 1.0)));
    }
    tracker.update(0.1 * scan, detections);
    for (const Track& track : tracker.ended()) {
      EXPECT_TRUE(alive.count(track.id));
      EXPECT_TRUE(dead.insert(track.id).second);
    }
    std::set<TrackId> now;
    for (const Track& track : tracker.tracks()) {
      EXPECT_FALSE(dead.count(track.id));
      EXPECT_TRUE(alive.count(track.id) || track.id > newest);
      now.insert(track.id);
    }
    if (!now.empty()) newest = std::max(newest, *now.rbegin());
    alive = now;
  }
  EXPECT_GT(dead.size(), 1000u);
}

TEST(Tracker, EndsATraceAtTheFifthMissInARow) {
  TrackingOptions options;
  options.lifecycle.maxMisses = 5;
  Tracker tracker(options);
  const std::vector<Detection> seen = {detectionOf(standingBox(0, 0, 1, 1))};
  int scan = 0;
  const auto show = [&](bool visible) {
    tracker.update(0.1 * scan++, visible ? seen : std::vector<Detection>{});
  };
  for (int round = 0; round < 4; ++round) {
    for (int i = 0; i < 3; ++i) show(true);
    for (int i = 0; i < 4; ++i) show(false);
    ASSERT_EQ(tracker.tracks().size(), 1u);
    EXPECT_EQ(tracker.tracks().front().id, 1u);
    EXPECT_EQ(tracker.tracks().front().misses, 4);
    EXPECT_FALSE(tracker.tracks().front().updated());
  }
  show(false);
  EXPECT_TRUE(tracker.tracks().empty());
  ASSERT_EQ(tracker.ended().size(), 1u);
  EXPECT_EQ(tracker.ended().front().hits, 12);
  EXPECT_EQ(tracker.ended().front().totalMisses, 17);
  show(true);
  EXPECT_TRUE(tracker.ended().empty());
  EXPECT_EQ(tracker.tracks().front().id, 2u);
}

TEST(Tracker, AutoMosCountsTheMissesOfAWholeLife) {
  TrackingOptions options;
  options.lifecycle.rule = LifeRule::AutoMos;
  options.lifecycle.maxMisses = 5;
  Tracker tracker(options);
  const std::vector<Detection> seen = {detectionOf(standingBox(0, 0, 1, 1))};
  for (int scan = 0; scan < 10; ++scan) {
    tracker.update(0.1 * scan, scan % 2 == 0 ? seen : std::vector<Detection>{});
  }
  EXPECT_TRUE(tracker.tracks().empty());
  EXPECT_EQ(tracker.ended().size(), 1u);
}

TEST(Tracker, LeavesOutBackgroundSmallAndDamagedBoxes) {
  std::vector<Detection> scan(5, detectionOf(standingBox(0, 0, 1, 1)));
  scan[0].background = true;
  scan[1].pointCount = 2;
  scan[2].box.center.y() = std::numeric_limits<double>::quiet_NaN();
  scan[3].box.length = std::numeric_limits<double>::infinity();
  Tracker tracker(TrackingOptions{});
  tracker.update(0.0, scan);
  EXPECT_EQ(tracker.trackOfDetection(), (std::vector<TrackId>{0, 0, 0, 0, 1}));
  tracker.update(0.1, {});
  EXPECT_TRUE(tracker.trackOfDetection().empty());
  EXPECT_EQ(tracker.tracks().size(), 1u);
}

TEST(Tracker, ConfirmsATraceAtItsThirdDetection) {
  Tracker tracker(TrackingOptions{});
  for (int scan = 0; scan < 3; ++scan) {
    tracker.update(0.1 * scan, {detectionOf(standingBox(0, 0, 1, 1))});
    EXPECT_EQ(tracker.tracks().front().confirmed, scan == 2);
  }
}

TEST(Tracker, WalkersThatMeetStayWhoTheyAre) {
  std::mt19937 random(11);
  TrackedScene scene;
  scene.add([&](double t) {
    return jittered(standingBox(-4.0 + 1.2 * t, 0.0, 0.5, 0.5, 1.7), 0.03, random);
  });
  scene.add([&](double t) {
    return jittered(standingBox(4.0 - 1.2 * t, 0.7, 0.5, 0.5, 1.7), 0.03, random);
  });
  scene.run(7.0);
  EXPECT_EQ(scene.ids(0), (std::set<TrackId>{1}));
  EXPECT_EQ(scene.ids(1), (std::set<TrackId>{2}));
}

/// Two walkers on neighbouring lines; while they pass each other, segmentation sees one thing.
std::vector<Detection> passingWalkers(double time, std::mt19937& random) {
  const double first = -4.0 + 1.2 * time, second = 4.0 - 1.2 * time;
  if (std::abs(first - second) > 0.7) {
    return {detectionOf(jittered(standingBox(first, 0.0, 0.5, 0.5, 1.7), 0.03, random)),
            detectionOf(jittered(standingBox(second, 0.7, 0.5, 0.5, 1.7), 0.03, random))};
  }
  const double length = 0.5 + std::abs(first - second);
  return {detectionOf(jittered(standingBox(0.0, 0.35, length, 1.2, 1.7), 0.03, random))};
}

TEST(Tracker, WalkersWhoseInstancesMergeAndSplitAreBothFollowedAgain) {
  std::mt19937 random(12);
  Tracker tracker(TrackingOptions{});
  std::set<TrackId> ids;
  for (int scan = 0; scan < 70; ++scan) {
    tracker.update(0.1 * scan, passingWalkers(0.1 * scan, random));
    for (const TrackId id : tracker.trackOfDetection()) ids.insert(id);
  }
  EXPECT_LE(ids.size(), 4u);
  int updated = 0;
  for (const Track& track : tracker.tracks()) {
    updated += track.updated() ? 1 : 0;
    EXPECT_TRUE(isDynamic(track.motion)) << track.id;
  }
  EXPECT_EQ(updated, 2);
}

TEST(Tracker, PaperNoiseReportsSpeedsInMetresPerSecondToo) {
  TrackingOptions options;
  options.kalman.noise = KalmanNoiseModel::Paper;
  for (const double rate : {5.0, 10.0}) {
    TrackedScene scene(options);
    scene.add([](double t) { return standingBox(5.0 * t, 0.0, 4.2, 1.8); });
    scene.run(8.0, rate);
    EXPECT_NEAR(scene.tracker.tracks().front().velocity.x(), 5.0, 0.1) << rate;
  }
}

TEST(Tracker, EveryAssociationMethodFollowsWellSeparatedObjects) {
  for (const auto method : {AssociationMethod::Hierarchical, AssociationMethod::Exhaustive,
                            AssociationMethod::AutoMos}) {
    TrackingOptions options;
    options.association.method = method;
    TrackedScene scene(options);
    for (int i = 0; i < 10; ++i) {
      scene.add([i](double t) { return standingBox(i * t, 10.0 * i, 2.0, 1.0); });
    }
    scene.run(3.0);
    for (std::size_t i = 0; i < 10; ++i) EXPECT_EQ(scene.ids(i).size(), 1u) << i;
  }
}

TEST(Tracker, RefusesTimesThatDoNotGrowAndOptionsOutOfRange) {
  Tracker tracker(TrackingOptions{});
  tracker.update(1.0, {});
  EXPECT_THROW(tracker.update(1.0, {}), std::logic_error);
  EXPECT_THROW(tracker.update(std::nan(""), {}), std::logic_error);
  TrackingOptions options;
  options.association.candidates = 0;
  EXPECT_THROW(Tracker{options}, UserError);
  MotionOptions motion;
  motion.window = -1.0;
  EXPECT_THROW(Tracker(TrackingOptions{}, motion), UserError);
}

}  // namespace
}  // namespace toss
