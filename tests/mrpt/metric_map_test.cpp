// SPDX-License-Identifier: BSD-3-Clause
// What MRPT's programs ask of a metric map.
#include <mrpt/maps/CMultiMetricMap.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/opengl/CPointCloudColoured.h>
#include <mrpt/opengl/CSetOfObjects.h>
#include <toss/rawlog/PlyFile.h>

#include <array>
#include <set>
#include <utility>

#include "MapFixtures.h"

namespace toss::test {
namespace {

/// A map of the first scans of the crossing.
class MrptMetricMap : public ::testing::Test {
 protected:
  static constexpr std::size_t kScans = 12;
  void SetUp() override {
    map_.insertionOptions = vlp16();
    map_.likelihoodOptions.decimation = 20;
    insertScans(map_, 0, kScans);
  }
  CDynamicFilteredPointsMap map_;
};

TEST_F(MrptMetricMap, IsTheSameAfterBeingWrittenAndRead) {
  map_.genericMapParams.enableObservationLikelihood = false;
  map_.likelihoodOptions.sigma_dist = 0.5;
  const auto read = writtenAndRead(map_);
  ASSERT_TRUE(read);
  EXPECT_TRUE(sameMap(pointsOf(read->points()), directMap(0, kScans)));
  EXPECT_FALSE(read->genericMapParams.enableObservationLikelihood);
  EXPECT_EQ(read->likelihoodOptions.sigma_dist, 0.5);
  EXPECT_EQ(read->insertionOptions.settings, map_.insertionOptions.settings);
}

TEST_F(MrptMetricMap, IsTheSameInsideAMultiMetricMap) {
  mrpt::maps::CMultiMetricMap maps;
  maps.maps.push_back(std::make_shared<CDynamicFilteredPointsMap>(map_));
  const mrpt::maps::CMultiMetricMap copy = maps;
  const auto read = writtenAndRead(copy);
  ASSERT_TRUE(read);
  const auto own = read->mapByClass<CDynamicFilteredPointsMap>();
  ASSERT_TRUE(own);
  EXPECT_TRUE(sameMap(pointsOf(own->points()), pointsOf(map_.points())));
}

TEST_F(MrptMetricMap, KeepsWhatItHasWhenMoreComesAfterTheEnd) {
  map_.finish();
  const std::size_t before = map_.points().size();
  insertScans(map_, kScans, crossing().size());
  map_.finish();
  const std::vector<MapPoint> all = pointsOf(map_.points());
  const std::vector<MapPoint> later = directMap(kScans, crossing().size());
  ASSERT_EQ(all.size(), before + later.size());
  EXPECT_TRUE(sameMap({all.begin(), all.begin() + static_cast<std::ptrdiff_t>(before)},
                      directMap(0, kScans)));
  EXPECT_TRUE(sameMap({all.begin() + static_cast<std::ptrdiff_t>(before), all.end()}, later));
}

TEST_F(MrptMetricMap, IsEmptyOnlyBeforeTheFirstScanAndWhenCleared) {
  EXPECT_TRUE(CDynamicFilteredPointsMap().isEmpty());
  EXPECT_FALSE(map_.isEmpty());
  map_.clear();
  EXPECT_TRUE(map_.isEmpty());
  EXPECT_EQ(map_.points().size(), 0u);
  insertScans(map_, 0, 1);
  EXPECT_FALSE(map_.isEmpty());
}

TEST_F(MrptMetricMap, ShowsAllScansAtOnce) {
  // No view has testified about any of them yet.
  CDynamicFilteredPointsMap young;
  young.insertionOptions = vlp16();
  insertScans(young, 0, 2);
  mrpt::opengl::CSetOfObjects shown;
  young.getVisualizationInto(shown);
  ASSERT_EQ(shown.size(), 1u);
  const auto cloud = shown.getByClass<mrpt::opengl::CPointCloudColoured>();
  ASSERT_TRUE(cloud);
  EXPECT_EQ(cloud->size(), young.points().size());
  EXPECT_GT(cloud->size(), 1000u);
  std::set<std::uint8_t> reds;
  for (std::size_t i = 0; i < cloud->size(); ++i) {
    std::uint8_t red = 0, green = 0, blue = 0;
    cloud->getPointColor_fast(i, red, green, blue);
    reds.insert(red);
  }
  EXPECT_GT(reds.size(), 5u);
}

TEST_F(MrptMetricMap, ShowsNothingWhereThatIsSwitchedOff) {
  map_.genericMapParams.enableSaveAs3DObject = false;
  mrpt::opengl::CSetOfObjects shown;
  map_.getVisualizationInto(shown);
  EXPECT_TRUE(shown.empty());
}

TEST_F(MrptMetricMap, GivesItsPointsToProgramsThatKnowPointMaps) {
  const mrpt::maps::CSimplePointsMap* simple = map_.getAsSimplePointsMap();
  ASSERT_NE(simple, nullptr);
  ASSERT_EQ(simple->size(), map_.points().size());
  float x = 0, y = 0, z = 0, ownX = 0, ownY = 0, ownZ = 0;
  simple->getPoint(7, x, y, z);
  map_.points().getPoint(7, ownX, ownY, ownZ);
  EXPECT_EQ(x, ownX);
  EXPECT_EQ(y, ownY);
  EXPECT_EQ(z, ownZ);
}

TEST_F(MrptMetricMap, IsLikeliestWhereTheScanWasTaken) {
  const PosedScan& scan = crossing()[kScans].scan;
  const auto observation = cloudObservation(1.6e9 + scan.time, scan);
  ASSERT_TRUE(map_.canComputeObservationLikelihood(*observation));
  const double there = map_.computeObservationLikelihood(*observation, poseOf(scan));
  EXPECT_LT(there, 0.0);
  for (const double offset : {0.3, 0.6, -0.4}) {
    const Eigen::Isometry3d aside =
        scan.mapFromSensor * toss::test::poseOf(offset, 0.5 * offset, 0, 0.02);
    EXPECT_GT(there, map_.computeObservationLikelihood(*observation, toMrpt(aside)));
  }
}

TEST_F(MrptMetricMap, HasTheLikelihoodOfItsDefinition) {
  const PosedScan& scan = crossing()[kScans].scan;
  const auto observation = cloudObservation(1.6e9 + scan.time, scan);
  const std::vector<MapPoint> points = pointsOf(map_.points());
  double sum = 0.0, count = 0.0;
  for (std::size_t i = 0; i < scan.points.size(); i += 20) {
    const Eigen::Vector3d p(scan.points.x[i], scan.points.y[i], scan.points.z[i]);
    if (!p.allFinite() || p.isZero()) continue;
    const Eigen::Vector3f inMap = (scan.mapFromSensor * p).cast<float>();
    float nearest = 1.0f;
    for (const MapPoint& each : points)
      nearest = std::min(nearest, (Eigen::Vector3f(each.x, each.y, each.z) - inMap).squaredNorm());
    sum += static_cast<double>(nearest);
    ++count;
  }
  const double expected = -sum / count / map_.likelihoodOptions.sigma_dist;
  EXPECT_NEAR(map_.computeObservationLikelihood(*observation, poseOf(scan)), expected,
              1e-3 * std::abs(expected));
}

TEST_F(MrptMetricMap, HasALikelihoodWhileItIsEmpty) {
  const PosedScan& scan = crossing().front().scan;
  EXPECT_LT(CDynamicFilteredPointsMap().computeObservationLikelihood(*cloudObservation(1.6e9, scan),
                                                                     poseOf(scan)),
            0.0);
}

TEST_F(MrptMetricMap, MatchesWithItselfAndItsPoints) {
  const mrpt::poses::CPose3D here;
  const std::array<const mrpt::maps::CMetricMap*, 3> same = {&map_, &map_.points(),
                                                             map_.getAsSimplePointsMap()};
  for (const mrpt::maps::CMetricMap* other : same) {
    EXPECT_GT(map_.compute3DMatchingRatio(other, here, {}), 0.99f);
    mrpt::tfest::TMatchingPairList pairs;
    mrpt::maps::TMatchingExtraResults results;
    map_.determineMatching3D(other, here, pairs, {}, results);
    EXPECT_GT(pairs.size(), map_.points().size() / 2);
  }
}

TEST_F(MrptMetricMap, MatchesWithNothingWhereThereAreNoPoints) {
  const CDynamicFilteredPointsMap empty;
  mrpt::tfest::TMatchingPairList pairs;
  mrpt::maps::TMatchingExtraResults results;
  for (const auto& [a, b] :
       {std::pair<const CDynamicFilteredPointsMap*, const CDynamicFilteredPointsMap*>{&map_,
                                                                                      &empty},
        {&empty, &map_}}) {
    EXPECT_EQ(a->compute3DMatchingRatio(b, mrpt::poses::CPose3D(), {}), 0.0f);
    a->determineMatching3D(b, mrpt::poses::CPose3D(), pairs, {}, results);
    EXPECT_TRUE(pairs.empty());
  }
}

TEST_F(MrptMetricMap, IsSavedAsTossMapSavesIt) {
  const TemporaryFolder folder;
  map_.saveMetricMapRepresentationToFile((folder / "map").string());
  for (const char* name : {"map.ply", "map.metricmap"})
    EXPECT_TRUE(sameMap(readPointCloudFile(folder / name), directMap(0, kScans))) << name;
}

}  // namespace
}  // namespace toss::test
