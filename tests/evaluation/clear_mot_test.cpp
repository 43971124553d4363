// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <toss/evaluation/ClearMot.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace toss::test {
namespace {

/// A scan in which object i may match track j with the given similarity.
TrackingScan scanOf(std::vector<std::uint64_t> objects, std::vector<std::uint64_t> tracks,
                    std::vector<TrackingScan::Pair> pairs) {
  TrackingScan scan;
  scan.objects = std::move(objects), scan.tracks = std::move(tracks);
  scan.excused.assign(scan.tracks.size(), false);
  scan.pairs = std::move(pairs);
  return scan;
}

/// One object, seen in every scan, followed by the track of each entry (0 = missed).
std::vector<TrackingScan> oneObjectFollowedBy(const std::vector<std::uint64_t>& tracks) {
  std::vector<TrackingScan> scans;
  for (const std::uint64_t track : tracks) {
    scans.push_back(track == 0 ? scanOf({7}, {}, {}) : scanOf({7}, {track}, {{0, 0, 0.75}}));
  }
  return scans;
}

TEST(ClearMot, OfPerfectTracksIsOne) {
  const ClearMot score = scoreTracks(oneObjectFollowedBy({5, 5, 5, 5}));
  EXPECT_DOUBLE_EQ(score.accuracy(), 1.0);
  EXPECT_DOUBLE_EQ(score.precision(), 0.75);
  EXPECT_DOUBLE_EQ(score.recall(), 1.0);
  EXPECT_EQ(score.mostlyTracked, 1u);
  EXPECT_EQ(score.identitySwitches + score.fragmentations, 0u);
}

TEST(ClearMot, CountsASwitchAcrossAGapAndTheGap) {
  const ClearMot score = scoreTracks(oneObjectFollowedBy({5, 5, 0, 0, 6, 6}));
  EXPECT_EQ(score.misses, 2u);
  EXPECT_EQ(score.identitySwitches, 1u);
  EXPECT_EQ(score.fragmentations, 1u);
  EXPECT_DOUBLE_EQ(score.accuracy(), 1.0 - 3.0 / 6.0);
}

TEST(ClearMot, DoesNotCountALateStartOrAnEarlyEndAsFragmentation) {
  const ClearMot score = scoreTracks(oneObjectFollowedBy({0, 5, 5, 0}));
  EXPECT_EQ(score.fragmentations, 0u);
  EXPECT_EQ(score.misses, 2u);
}

TEST(ClearMot, KeepsThePairOfTheScanBefore) {
  // Track 6 fits better in the second scan, but the object stays with track 5.
  const ClearMot score = scoreTracks(
      {scanOf({7}, {5}, {{0, 0, 0.9}}), scanOf({7}, {5, 6}, {{0, 0, 0.5}, {0, 1, 0.9}})});
  EXPECT_EQ(score.identitySwitches, 0u);
  EXPECT_EQ(score.falseAlarms, 1u);
  EXPECT_DOUBLE_EQ(score.similarity, 1.4);
}

TEST(ClearMot, MatchesMostPairsAndThenTheMostSimilar) {
  // Greedy would take 0.9 and leave object 2 alone.
  const ClearMot most =
      scoreTracks({scanOf({1, 2}, {5, 6}, {{0, 0, 0.9}, {0, 1, 0.4}, {1, 0, 0.3}})});
  EXPECT_EQ(most.matches, 2u);
  EXPECT_DOUBLE_EQ(most.similarity, 0.7);
  const ClearMot similar =
      scoreTracks({scanOf({1, 2}, {5, 6}, {{0, 0, 0.9}, {0, 1, 0.8}, {1, 0, 0.8}, {1, 1, 0.1}})});
  EXPECT_DOUBLE_EQ(similar.similarity, 1.6);
}

TEST(ClearMot, ExcusesTracksWhereNothingIsAnnotated) {
  TrackingScan scan = scanOf({}, {5, 6}, {});
  scan.excused[1] = true;
  EXPECT_EQ(scoreTracks({scan}).falseAlarms, 1u);
}

TEST(ClearMot, IsUndefinedWithoutObjects) {
  EXPECT_TRUE(std::isnan(scoreTracks({}).accuracy()));
  EXPECT_TRUE(std::isnan(averageAccuracy({}, {}).amota));
}

TEST(ClearMot, LeavesOutTracksOfLowConfidence) {
  const ClearMot score = scoreTracks(oneObjectFollowedBy({5, 6}), {{5, 2.0}, {6, 1.0}}, 1.5);
  EXPECT_EQ(score.matches, 1u);
  EXPECT_EQ(score.falseAlarms, 0u);
}

TEST(ClearMot, TellsMostlyTrackedFromMostlyLost) {
  EXPECT_EQ(scoreTracks(oneObjectFollowedBy({5, 5, 5, 5, 0})).mostlyTracked, 0u);  // 80 %
  EXPECT_EQ(scoreTracks(oneObjectFollowedBy({5, 5, 5, 5, 5, 0})).mostlyTracked, 1u);
  EXPECT_EQ(scoreTracks(oneObjectFollowedBy({5, 0, 0, 0, 0})).mostlyLost, 0u);  // 20 %
  EXPECT_EQ(scoreTracks(oneObjectFollowedBy({5, 0, 0, 0, 0, 0})).mostlyLost, 1u);
}

/// 40 objects, one scan; the first `found` of them matched by tracks of descending confidence.
struct RankedTracks {
  std::vector<TrackingScan> scans{1};
  TrackConfidence confidence;

  explicit RankedTracks(int found) {
    for (int i = 0; i < 40; ++i) {
      scans[0].objects.push_back(static_cast<std::uint64_t>(i));
      if (i >= found) continue;
      scans[0].tracks.push_back(static_cast<std::uint64_t>(100 + i));
      scans[0].pairs.push_back({i, i, 0.5});
      confidence[static_cast<std::uint64_t>(100 + i)] = 40.0 - i;
    }
    scans[0].excused.assign(scans[0].tracks.size(), false);
  }
};

TEST(AveragedAccuracy, OfRankedPerfectTracksHasAClosedForm) {
  // Step k of 40 keeps k + 1 tracks, MOTA = (k + 1) / 40, for k = 1..39: the walk takes the first
  // match for recall 0, so that step 40 is not reached.
  const RankedTracks ranked(40);
  const AveragedAccuracy average = averageAccuracy(ranked.scans, ranked.confidence);
  double sum = 0.0;
  for (int k = 1; k <= 39; ++k) sum += (k + 1) / 40.0;
  EXPECT_NEAR(average.amota, sum / 40.0, 1e-12);
  EXPECT_NEAR(average.samota, 39.0 / 40.0, 1e-12);
  EXPECT_NEAR(average.amotp, 0.5 * 39.0 / 40.0, 1e-12);
}

TEST(AveragedAccuracy, AddsNothingForRecallThatIsNotReached) {
  const RankedTracks ranked(20);
  const AveragedAccuracy average = averageAccuracy(ranked.scans, ranked.confidence);
  EXPECT_NEAR(average.samota, 19.0 / 40.0, 1e-12);
}

TEST(AveragedAccuracy, CountsFalseAlarmsOnlyWhereTheirConfidenceIsReached) {
  RankedTracks ranked(40);
  const double clean = averageAccuracy(ranked.scans, ranked.confidence).amota;
  ranked.scans[0].tracks.push_back(999);
  ranked.scans[0].excused.push_back(false);
  ranked.confidence[999] = 0.5;  // below all matches
  EXPECT_DOUBLE_EQ(averageAccuracy(ranked.scans, ranked.confidence).amota, clean);
  ranked.confidence[999] = 50.0;  // above all: one false alarm in each of the 39 steps
  EXPECT_NEAR(averageAccuracy(ranked.scans, ranked.confidence).amota, clean - 39.0 / 40.0 / 40.0,
              1e-12);
}

TEST(TrackConfidence, IsTheNumberOfScansInWhichATrackIsReported) {
  const TrackConfidence confidence = confidenceByLength(oneObjectFollowedBy({5, 5, 0, 6}));
  EXPECT_EQ(confidence, (TrackConfidence{{5, 2.0}, {6, 1.0}}));
}

/// Most pairs, then greatest similarity, by trying every assignment of tracks to objects.
std::pair<int, double> bestByTryingAll(const TrackingScan& scan, std::size_t object,
                                       std::vector<bool> taken) {
  if (object == scan.objects.size()) return {0, 0.0};
  std::pair<int, double> best = bestByTryingAll(scan, object + 1, taken);
  for (const TrackingScan::Pair& pair : scan.pairs) {
    const auto track = static_cast<std::size_t>(pair.track);
    if (pair.object != static_cast<std::int32_t>(object) || taken[track]) continue;
    taken[track] = true;
    auto [pairs, similarity] = bestByTryingAll(scan, object + 1, taken);
    best = std::max(best, std::make_pair(pairs + 1, similarity + pair.similarity));
    taken[track] = false;
  }
  return best;
}

TEST(ClearMot, OfRandomScansMatchesAsByTryingAll) {
  std::mt19937 random(11);
  for (int trial = 0; trial < 200; ++trial) {
    TrackingScan scan = scanOf({1, 2, 3, 4}, {5, 6, 7, 8, 9}, {});
    for (int o = 0; o < 4; ++o) {
      for (int t = 0; t < 5; ++t) {
        if (random() % 2) scan.pairs.push_back({o, t, static_cast<double>(random() % 64) / 64.0});
      }
    }
    const auto [pairs, similarity] = bestByTryingAll(scan, 0, std::vector<bool>(5, false));
    const ClearMot score = scoreTracks({scan});
    ASSERT_EQ(score.matches, static_cast<std::uint64_t>(pairs));
    ASSERT_NEAR(score.similarity, similarity, 1e-9);
  }
}

}  // namespace
}  // namespace toss::test
