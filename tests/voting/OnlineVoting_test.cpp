// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <random>
#include <set>

#include "VotingScene.h"

namespace toss {
namespace {

using test::VotingScene;

/// Traces that stand, creep, pass and wait on a few square metres, with missed scans, boxes without
/// a trace, uneven times, and random final classes.
VotingScene randomScene(unsigned seed, int frames) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  VotingScene scene;
  TrackId nextTrack = 1;
  for (int k = 0; k < 40; ++k) {
    const int first = static_cast<int>(unit(random) * frames);
    const int length = 1 + static_cast<int>(unit(random) * unit(random) * frames);
    const double speed = unit(random) < 0.5 ? 0.0 : 4.0 * unit(random) * unit(random);
    const TrackId track = unit(random) < 0.1 ? 0 : nextTrack++;
    double x = 8.0 * unit(random) - 4.0;
    const double y = 8.0 * unit(random) - 4.0;
    for (int frame = first; frame < std::min(frames, first + length); ++frame) {
      x += 0.1 * speed;
      if (unit(random) < 0.2) continue;
      const double volume = std::exp(3.0 * unit(random) - 1.0);
      const auto place = scene.add(track, frame, {x + 0.1 * unit(random), y, volume, speed});
      scene.boxes[place].extent = 4.0 * unit(random);
    }
    if (unit(random) < 0.5) {
      scene.classOf[track] = unit(random) < 0.6 ? MotionClass::Weak : MotionClass::Strong;
    }
  }
  scene.classOf.erase(0);
  std::vector<double> times(static_cast<std::size_t>(frames));
  for (std::size_t i = 0; i < times.size(); ++i) {
    times[i] = 1.5e9 + 0.1 * static_cast<double>(i) + 0.02 * unit(random);
  }
  for (VotingBox& box : scene.boxes) box.time = times[static_cast<std::size_t>(box.scan)];
  return scene;
}

/// Runs a scene online; traces get their final class at random times, by way of Weak, and some that
/// stay static are dynamic for a while. Calls `afterScan(voting, ids)` after each scan.
template <typename AfterScan>
std::vector<BoxId> run(const VotingScene& scene, unsigned seed, DsVoting& voting,
                       AfterScan&& afterScan) {
  std::mt19937 random(seed);
  std::vector<BoxId> ids(scene.boxes.size());
  std::set<TrackId> tracks;
  for (const VotingBox& box : scene.boxes) tracks.insert(box.track);
  tracks.erase(0);
  const auto classes = [](unsigned roll) { return static_cast<MotionClass>(roll % 3); };
  for (const auto& [number, scan] : scene.scans()) {
    for (const TrackId track : tracks) {
      const unsigned roll = static_cast<unsigned>(random());
      if (roll % 97 == 0) voting.setTrackClass(track, classes(roll / 97));
      if (roll % 41 == 0) voting.setTrackClass(track, scene.motion(track));
    }
    const BoxId first = voting.addScan(scan.boxes);
    for (std::size_t i = 0; i < scan.places.size(); ++i) ids[scan.places[i]] = first + i;
    afterScan(voting, ids);
  }
  for (const TrackId track : tracks) voting.setTrackClass(track, scene.motion(track));
  return ids;
}

std::vector<VotingOptions> allOptions() {
  std::vector<VotingOptions> result;
  for (const VotingMode mode : {VotingMode::Off, VotingMode::Literal, VotingMode::DynamicOnly,
                                VotingMode::Classwise, VotingMode::Guarded}) {
    for (const EmptyVote empty : {EmptyVote::ByMode, EmptyVote::Coarse, EmptyVote::Dynamic}) {
      for (const double horizon : {0.0, 4.0}) {
        VotingOptions options;
        options.mode = mode;
        options.emptyVote = empty;
        options.horizon = horizon;
        if (empty == EmptyVote::ByMode) options.tauDriftPerSecond = 0.1;
        if (empty == EmptyVote::Coarse) options.dynamicSizeCompatibility = 0.5;
        result.push_back(options);
      }
    }
  }
  return result;
}

std::string nameOf(const VotingOptions& options) {
  return "mode " + std::to_string(static_cast<int>(options.mode)) + " empty " +
         std::to_string(static_cast<int>(options.emptyVote)) + " horizon " +
         std::to_string(options.horizon);
}

TEST(OnlineVoting, EqualsOfflineAfterAllScans) {
  for (const VotingOptions& options : allOptions()) {
    SCOPED_TRACE(nameOf(options));
    for (unsigned seed = 0; seed < 8; ++seed) {
      const VotingScene scene = randomScene(seed, 100);
      const auto expected = voteOffline(scene.boxes, scene.classes(), options);
      DsVoting voting(options);
      const auto ids = run(scene, seed, voting, [](const DsVoting&, const auto&) {});
      for (std::size_t i = 0; i < ids.size(); ++i) {
        ASSERT_EQ(voting.isDynamic(ids[i]), expected[i]) << "seed " << seed << " box " << i;
      }
    }
  }
}

TEST(OnlineVoting, EqualsOfflineOverThePrefixAfterEveryScan) {
  VotingOptions options;
  const VotingScene scene = randomScene(3, 60);
  DsVoting voting(options);
  VotingScene seen;
  seen.classOf = scene.classOf;
  for (const auto& [track, motion] : scene.classOf) voting.setTrackClass(track, motion);
  std::vector<BoxId> ids;
  for (const auto& [number, scan] : scene.scans()) {
    const BoxId first = voting.addScan(scan.boxes);
    for (std::size_t i = 0; i < scan.boxes.size(); ++i) ids.push_back(first + i);
    seen.boxes.insert(seen.boxes.end(), scan.boxes.begin(), scan.boxes.end());
    const auto expected = voteOffline(seen.boxes, seen.classes(), options);
    for (std::size_t i = 0; i < ids.size(); ++i) {
      ASSERT_EQ(voting.isDynamic(ids[i]), expected[i]) << "scan " << number << " box " << i;
    }
  }
}

TEST(OnlineVoting, ScenesHoldBothLabelsAndVotesThatMatter) {
  const VotingScene scene = randomScene(1, 100);
  VotingOptions options;
  const auto voted = voteOffline(scene.boxes, scene.classes(), options);
  options.mode = VotingMode::Off;
  const auto coarse = voteOffline(scene.boxes, scene.classes(), options);
  int raised = 0, lowered = 0;
  for (std::size_t i = 0; i < voted.size(); ++i) {
    raised += voted[i] && !coarse[i];
    lowered += !voted[i] && coarse[i];
  }
  EXPECT_GT(raised, 10);
  EXPECT_GT(lowered, 10);
}

TEST(OnlineVoting, ChangesAddUpToTheLabels) {
  for (const VotingMode mode : {VotingMode::Literal, VotingMode::Guarded}) {
    VotingOptions options;
    options.mode = mode;
    const VotingScene scene = randomScene(5, 100);
    DsVoting voting(options);
    std::map<BoxId, bool> label;
    const auto follow = [&](DsVoting& v, const auto&) {
      const std::vector<BoxId> changes = v.takeChanges();
      EXPECT_TRUE(std::is_sorted(changes.begin(), changes.end()));
      EXPECT_EQ(std::set<BoxId>(changes.begin(), changes.end()).size(), changes.size());
      for (const BoxId box : changes) {
        label[box] = !label[box];
        EXPECT_EQ(label[box], v.isDynamic(box));
      }
    };
    const auto ids = run(scene, 5, voting, follow);
    follow(voting, ids);
    for (const BoxId box : ids) EXPECT_EQ(label[box], voting.isDynamic(box));
    EXPECT_TRUE(voting.takeChanges().empty());
  }
}

TEST(OnlineVoting, ReleasingAndForgettingLeaveLaterLabelsAlone) {
  for (const VotingMode mode : {VotingMode::Literal, VotingMode::Classwise, VotingMode::Guarded}) {
    VotingOptions options;
    options.mode = mode;
    options.horizon = 4.0;
    const VotingScene scene = randomScene(7, 300);
    DsVoting reference(options), voting(options);
    const auto referenceIds = run(scene, 7, reference, [](const DsVoting&, const auto&) {});
    std::set<BoxId> released;
    std::int64_t number = -1;
    const auto settle = [&](DsVoting& v, const std::vector<BoxId>& ids) {
      ++number;
      const double settled = 1.5e9 + 0.1 * static_cast<double>(number) - options.horizon;
      v.forgetBefore(settled);
      for (std::size_t i = 0; i < ids.size(); ++i) {
        if (scene.boxes[i].time < settled && released.insert(ids[i]).second) v.release(ids[i]);
      }
    };
    const auto ids = run(scene, 7, voting, settle);
    ASSERT_EQ(ids, referenceIds);
    std::size_t compared = 0;
    for (const BoxId box : ids) {
      if (released.count(box)) continue;
      EXPECT_EQ(voting.isDynamic(box), reference.isDynamic(box)) << box;
      ++compared;
    }
    EXPECT_GT(compared, 50u);
    EXPECT_GT(released.size(), compared);
  }
}

TEST(OnlineVoting, SettledBoxesKeepTheirLabels) {
  DsVoting voting(VotingOptions{});
  VotingScene scene;
  scene.stand(1, 0, 20, {});
  BoxId last = 0;
  for (const auto& [number, scan] : scene.scans()) last = voting.addScan(scan.boxes);
  voting.forgetBefore(1.0);
  voting.setTrackClass(1, MotionClass::Strong);
  EXPECT_FALSE(voting.isDynamic(0));
  EXPECT_TRUE(voting.isDynamic(last));
}

TEST(OnlineVoting, RisingClassReachesAllBoxesOfTheTrace) {
  DsVoting voting(VotingOptions{});
  VotingScene scene;
  scene.drive(1, 0, 30, 0, {0, 0, 10, 3});
  std::vector<BoxId> ids;
  for (const auto& [number, scan] : scene.scans()) ids.push_back(voting.addScan(scan.boxes));
  EXPECT_TRUE(voting.takeChanges().empty());
  voting.setTrackClass(1, MotionClass::Weak);
  EXPECT_EQ(voting.takeChanges(), ids);
}

TEST(OnlineVoting, ChangesThatWereLongNotAskedForAreToldOnce) {
  DsVoting voting(VotingOptions{});
  VotingScene scene;
  scene.drive(1, 0, 30, 0, {0, 0, 10, 3});
  std::vector<BoxId> ids;
  for (const auto& [number, scan] : scene.scans()) ids.push_back(voting.addScan(scan.boxes));
  ASSERT_GT(ids.size(), 20u);
  // More changes than are kept as they come.
  for (int k = 0; k <= 400; ++k)
    voting.setTrackClass(1, k % 2 == 0 ? MotionClass::Strong : MotionClass::Static);
  const std::vector<BoxId> left(ids.begin() + 10, ids.end());
  for (std::size_t i = 0; i < 10; ++i) voting.release(ids[i]);
  EXPECT_EQ(voting.takeChanges(), left);
  EXPECT_TRUE(voting.takeChanges().empty());
}

TEST(OnlineVoting, BoxesSpreadOverManyCellsOfOneRow) {
  DsVoting voting(VotingOptions{});
  VotingScene scene;
  for (int k = 0; k < 30000; ++k) scene.add(static_cast<TrackId>(k + 1), 0, {3.0 * k, 0.1});
  voting.addScan(scene.boxes);
  voting.setTrackClass(500, MotionClass::Weak);
  EXPECT_EQ(voting.takeChanges(), std::vector<BoxId>{499});
}

TEST(OnlineVoting, RejectsWhatCanNotBe) {
  DsVoting voting(VotingOptions{});
  VotingBox box;
  box.scan = 5;
  box.time = 1.0;
  EXPECT_EQ(voting.addScan({}), 0u);
  EXPECT_EQ(voting.addScan({box}), 0u);
  EXPECT_THROW(voting.addScan({box}), std::logic_error);
  box.scan = 6;
  EXPECT_THROW(voting.addScan({box}), std::logic_error);
  box.time = 2.0;
  box.center.x() = std::nan("");
  EXPECT_THROW(voting.addScan({box}), std::logic_error);
  box.center.x() = 1e300;
  EXPECT_EQ(voting.addScan({box}), 1u);
  EXPECT_THROW(voting.isDynamic(2), std::logic_error);
  voting.release(1);
  EXPECT_THROW(voting.isDynamic(1), std::logic_error);
  EXPECT_THROW(voting.setTrackClass(0, MotionClass::Weak), std::logic_error);
}

}  // namespace
}  // namespace toss
