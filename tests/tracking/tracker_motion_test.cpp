// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "TrackedScene.h"

namespace toss {
namespace {

constexpr std::size_t kFirst = 0;

TEST(TrackerMotion, LeadingCarSeenByItsThinRearFaceKeepsOneTrace) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> thickness(0.04, 0.2);
  TrackedScene scene;
  // 0.7 m per scan: consecutive boxes never overlap.
  scene.add([&](double t) { return standingBox(10.0 + 7.0 * t, 0.0, thickness(random), 1.7); });
  scene.run(6.0);
  EXPECT_EQ(scene.ids(kFirst).size(), 1u);
  EXPECT_EQ(scene.motionOf(kFirst), MotionClass::Strong);
  EXPECT_NEAR(scene.tracker.tracks().front().velocity.x(), 7.0, 0.5);
}

TEST(TrackerMotion, CarsAtMotorwaySpeedStartTracesAtTenScansPerSecond) {
  for (const double speed : {30.0, -33.0}) {
    std::mt19937 random(2);
    TrackedScene scene;
    scene.add(
        [&](double t) { return jittered(standingBox(speed * t, 3.0, 4.2, 1.8), 0.05, random); });
    scene.run(1.5);
    EXPECT_EQ(scene.ids(kFirst).size(), 1u) << speed;
    EXPECT_EQ(scene.motionOf(kFirst), MotionClass::Strong) << speed;
    EXPECT_NEAR(scene.tracker.tracks().front().velocity.x(), speed, 1.0);
  }
}

TEST(TrackerMotion, MotorwaySpeedNeedsTheNewbornGate) {
  TrackingOptions options;
  options.newborn.enabled = false;
  TrackedScene scene(options);
  scene.add([](double t) { return standingBox(30.0 * t, 3.0, 4.2, 1.8); });
  scene.run(1.5);
  EXPECT_EQ(scene.ids(kFirst).size(), 15u);
}

TEST(TrackerMotion, WalkersAreFoundAtEverySpeedAndRate) {
  for (const double rate : {5.0, 10.0, 20.0}) {
    for (const double speed : {0.3, 0.8, 1.4, 3.0}) {
      std::mt19937 random(3);
      TrackedScene scene;
      scene.add([&](double t) {
        return jittered(standingBox(speed * t, 0.5 * speed * t, 0.5, 0.5, 1.7), 0.03, random);
      });
      scene.run(6.0, rate);
      EXPECT_EQ(scene.ids(kFirst).size(), 1u) << speed << " m/s, " << rate << " scans/s";
      EXPECT_TRUE(isDynamic(scene.motionOf(kFirst))) << speed << " m/s, " << rate << " scans/s";
    }
  }
}

TEST(TrackerMotion, BackAndForthIsMotionThoughTheNetDisplacementIsZero) {
  std::mt19937 random(4);
  TrackedScene scene;
  scene.add([&](double t) {
    return jittered(standingBox(1.5 * std::sin(0.8 * t), 0.0, 0.5, 0.5, 1.7), 0.03, random);
  });
  scene.run(15.7);
  EXPECT_TRUE(isDynamic(scene.motionOf(kFirst)));
}

TEST(TrackerMotion, VehiclesOfAllLengthsAndOnBendsAreFound) {
  for (const double length : {1.8, 4.2, 12.0, 18.0}) {
    std::mt19937 random(5);
    TrackedScene straight, bend;
    straight.add([&](double t) {
      return jittered(standingBox(8.0 * t, 0.0, length, 2.5, 3.0), 0.08, random);
    });
    bend.add([&](double t) {
      const double angle = 8.0 / 15.0 * t, sine = std::abs(std::sin(angle)),
                   cosine = std::abs(std::cos(angle));
      return jittered(standingBox(15.0 * std::sin(angle), -15.0 * std::cos(angle),
                                  length * cosine + 2.0 * sine, length * sine + 2.0 * cosine, 3.0),
                      0.08, random);
    });
    straight.run(5.0);
    bend.run(5.0);
    EXPECT_EQ(straight.motionOf(kFirst), MotionClass::Strong) << length;
    EXPECT_TRUE(isDynamic(bend.motionOf(kFirst))) << length;
  }
}

TEST(TrackerMotion, CarThatLeavesAfterAMinuteIsFound) {
  std::mt19937 random(6);
  TrackedScene scene;
  scene.add([&](double t) {
    const double driven = t < 60.0 ? 0.0 : std::min(0.5 * (t - 60.0) * (t - 60.0), 100.0);
    return jittered(standingBox(driven, 0.0, 4.2, 1.8), 0.05, random);
  });
  scene.run(60.0);
  EXPECT_EQ(scene.motionOf(kFirst), MotionClass::Static);
  scene.run(6.0);
  EXPECT_EQ(scene.ids(kFirst).size(), 1u);
  EXPECT_TRUE(isDynamic(scene.motionOf(kFirst)));
}

TEST(TrackerMotion, GrowingAndShrinkingViewsOfAWallStayStatic) {
  std::mt19937 random(7);
  TrackedScene scene;
  scene.add([&](double t) {
    const double visible = 1.0 + 3.0 * t;
    return jittered(standingBox(0.5 * visible, 0.0, visible, 0.3, 2.5), 0.03, random);
  });
  scene.add([&](double t) {
    const double visible = 16.0 - 3.0 * t;
    return jittered(standingBox(0.5 * visible, 20.0, visible, 0.3, 2.5), 0.03, random);
  });
  scene.run(5.0);
  EXPECT_EQ(scene.motionOf(0), MotionClass::Static);
  EXPECT_EQ(scene.motionOf(1), MotionClass::Static);
}

TEST(TrackerMotion, ParkedCarsAndRestlessHedgesStayStatic) {
  std::mt19937 random(8);
  TrackedScene scene;
  for (int i = 0; i < 40; ++i) {
    scene.add([&random, i](double) {
      return jittered(standingBox(0.0, 8.0 * i, 4.2, 1.8), 0.1, random);
    });
    scene.add([&random, i](double) {
      return jittered(standingBox(30.0, 8.0 * i, 1.5, 1.2, 1.0), 0.4, random);
    });
  }
  scene.run(30.0);
  for (std::size_t i = 0; i < 80; ++i) EXPECT_FALSE(isDynamic(scene.motionOf(i))) << i;
}

TEST(TrackerMotion, TracesOfGroundAreNoMovers) {
  TrackedScene scene;
  scene.add([](double t) { return standingBox(4.0 * t, 0.0, 1.2, 0.6, 0.1); });
  scene.run(4.0);
  EXPECT_EQ(scene.motionOf(kFirst), MotionClass::Static);
}

TEST(TrackerMotion, AHeadAboveAHedgeMovesDoubtfully) {
  TrackedScene scene;
  scene.add([](double t) { return standingBox(1.0 * t, 0.0, 0.2, 0.15, 0.2); });
  scene.add([](double t) { return standingBox(1.0 * t, 20.0, 0.2, 0.15, 0.4); });
  scene.run(4.0);
  EXPECT_EQ(scene.motionOf(0), MotionClass::Doubtful);
  EXPECT_TRUE(isDynamic(scene.motionOf(1)));
}

TEST(TrackerMotion, WhatWandersBehindAnOpeningIsNoMover) {
  Tracker open(TrackingOptions{}), hidden(TrackingOptions{});
  for (int scan = 0; scan < 40; ++scan) {
    Detection detection = detectionOf(standingBox(0.2 * scan, 0.0, 1.5, 0.4, 1.5));
    open.update(0.1 * scan, {detection});
    detection.occludedLeft = detection.occludedRight = 0.8f;
    hidden.update(0.1 * scan, {detection});
  }
  EXPECT_TRUE(isDynamic(open.tracks().front().motion));
  EXPECT_EQ(hidden.tracks().front().motion, MotionClass::Doubtful);
}

TEST(TrackerMotion, SingleColumnsOfAWallAreNoMovers) {
  TrackedScene scene;
  scene.add([](double t) { return standingBox(2.0 * t, 0.0, 0.08, 0.05, 2.0); });
  scene.run(4.0);
  EXPECT_EQ(scene.motionOf(kFirst), MotionClass::Static);
}

TEST(TrackerMotion, NarrowSlicesOfAWallBehindAnOpeningAreNoMovers) {
  Tracker slice(TrackingOptions{}), person(TrackingOptions{});
  const auto hidden = [](const Box& box) {
    Detection detection = detectionOf(box);
    detection.occludedLeft = detection.occludedRight = 0.8f;
    return detection;
  };
  for (int scan = 0; scan < 40; ++scan) {
    slice.update(0.1 * scan, {hidden(standingBox(0.1 * scan, 0.0, 0.4, 0.1, 3.0))});
    person.update(0.1 * scan, {hidden(standingBox(0.1 * scan, 0.0, 0.4, 0.4, 1.7))});
  }
  EXPECT_EQ(slice.tracks().front().motion, MotionClass::Static);
  EXPECT_EQ(person.tracks().front().motion, MotionClass::Doubtful);
}

TEST(TrackerMotion, AutoMosRuleAsksForTheLongestEdge) {
  MotionOptions options;
  options.rule = MotionRule::AutoMos;
  TrackedScene scene({}, options);
  scene.add([](double t) { return standingBox(1.0 * t, 0.0, 0.5, 0.5, 1.7); });
  scene.run(1.65);
  EXPECT_EQ(scene.motionOf(kFirst), MotionClass::Static);
  scene.run(0.5);
  EXPECT_TRUE(isDynamic(scene.motionOf(kFirst)));
}

}  // namespace
}  // namespace toss
