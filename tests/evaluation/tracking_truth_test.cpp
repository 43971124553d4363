// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <toss/evaluation/TrackingTruth.h>

namespace toss::test {
namespace {

using testing::ElementsAre;

constexpr std::uint32_t with(std::uint32_t semantic, std::uint32_t instance) {
  return instance << 16 | semantic;
}

struct LabelPair {
  std::vector<std::uint32_t> truth, called;

  void add(int count, std::uint32_t trueLabel, std::uint32_t calledLabel) {
    truth.insert(truth.end(), static_cast<std::size_t>(count), trueLabel);
    called.insert(called.end(), static_cast<std::size_t>(count), calledLabel);
  }
};

TEST(TrackingFromLabels, TakesTheOverlapOfReturnsAsSimilarity) {
  LabelPair labels;
  labels.add(30, with(252, 1), with(251, 8));
  labels.add(10, with(252, 1), with(9, 0));
  labels.add(10, with(9, 0), with(251, 8));
  const TrackingScan scan = trackingScanFromLabels(labels.truth, labels.called, true, {});
  ASSERT_THAT(scan.objects, ElementsAre(with(252, 1)));
  ASSERT_THAT(scan.tracks, ElementsAre(8));
  ASSERT_EQ(scan.pairs.size(), 1u);
  EXPECT_DOUBLE_EQ(scan.pairs[0].similarity, 30.0 / 50.0);
}

TEST(TrackingFromLabels, GatesByOverlap) {
  LabelPair labels;
  labels.add(24, with(252, 1), with(251, 8));
  labels.add(26, with(252, 1), with(9, 8));  // called static: not in the track
  EXPECT_TRUE(trackingScanFromLabels(labels.truth, labels.called, true, {}).pairs.empty());
  EvaluationOptions loose;
  loose.trackingOverlap = 0.4;
  EXPECT_EQ(trackingScanFromLabels(labels.truth, labels.called, true, loose).pairs.size(), 1u);
}

TEST(TrackingFromLabels, TellsObjectsOfOneNumberApartByClass) {
  LabelPair labels;
  labels.add(20, with(252, 1), with(251, 8));
  labels.add(20, with(254, 1), with(251, 9));
  const TrackingScan scan = trackingScanFromLabels(labels.truth, labels.called, true, {});
  EXPECT_EQ(scan.objects.size(), 2u);
  EXPECT_EQ(scan.pairs.size(), 2u);
}

TEST(TrackingFromLabels, DoesNotAskForObjectsOfFewReturnsAndExcusesTheirTracks) {
  LabelPair labels;
  labels.add(9, with(252, 1), with(251, 8));
  const TrackingScan scan = trackingScanFromLabels(labels.truth, labels.called, true, {});
  EXPECT_TRUE(scan.objects.empty());
  EXPECT_THAT(scan.tracks, ElementsAre(8));
  EXPECT_THAT(scan.excused, ElementsAre(true));
}

TEST(TrackingFromLabels, ExcusesTracksOfFewReturns) {
  LabelPair labels;
  labels.add(9, with(9, 0), with(251, 8));
  labels.add(10, with(9, 0), with(251, 9));
  EXPECT_THAT(trackingScanFromLabels(labels.truth, labels.called, true, {}).excused,
              ElementsAre(true, false));
}

TEST(TrackingFromLabels, ExcusesTracksWhereNothingIsAnnotated) {
  LabelPair labels;
  labels.add(20, with(0, 0), with(251, 8));
  EXPECT_THAT(trackingScanFromLabels(labels.truth, labels.called, true, {}).excused,
              ElementsAre(true));
  EXPECT_THAT(trackingScanFromLabels(labels.truth, labels.called, false, {}).excused,
              ElementsAre(false));
}

TrackRow row(std::uint64_t scan, TrackId track, bool moving, double x, double z = 0.0) {
  TrackRow result;
  result.scan = scan;
  result.sample.track = track, result.sample.moving = moving;
  result.sample.box.center = {x, 0.0, z};
  result.sample.box.length = 4.0, result.sample.box.width = 2.0, result.sample.box.height = 1.0;
  return result;
}

TEST(TrackingFromBoxes, MatchesMovingBoxesOfTheSameScanByHorizontalDistance) {
  const std::vector<TrackingScan> scans = trackingScansFromBoxes(
      {row(3, 1, true, 0.0), row(3, 2, false, 10.0), row(4, 1, true, 5.0)},
      {row(3, 8, true, 1.0, 9.0), row(3, 9, false, 0.0), row(4, 8, true, 7.5)}, {3, 4, 5}, {});
  ASSERT_EQ(scans.size(), 3u);
  EXPECT_THAT(scans[0].objects, ElementsAre(1));
  EXPECT_THAT(scans[0].tracks, ElementsAre(8));
  ASSERT_EQ(scans[0].pairs.size(), 1u);
  EXPECT_DOUBLE_EQ(scans[0].pairs[0].similarity, 0.5);  // 1 m of at most 2 m
  EXPECT_TRUE(scans[1].pairs.empty());                  // 2.5 m apart
  EXPECT_TRUE(scans[2].objects.empty());
}

TEST(TrackingFromBoxes, MatchesByOverlapWhereAskedTo) {
  EvaluationOptions options;
  options.boxMatch = BoxMatch::Overlap;
  const auto scans = trackingScansFromBoxes(
      {row(0, 1, true, 0.0)}, {row(0, 8, true, 1.0), row(0, 9, true, 3.0)}, {0}, options);
  ASSERT_EQ(scans[0].pairs.size(), 1u);
  EXPECT_NEAR(scans[0].pairs[0].similarity, 3.0 / 5.0, 1e-12);
}

}  // namespace
}  // namespace toss::test
