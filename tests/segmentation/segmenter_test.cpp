// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <toss/segmentation/Segmenter.h>

#include <algorithm>

#include "GroundTestScene.h"
#include "RealScans.h"

namespace toss::test {
namespace {

/// Every return has one class, and instances, members and heights agree with the classes.
void expectConsistent(const SegmentedScan& scan, std::size_t n) {
  const Segmentation& s = scan.segmentation;
  ASSERT_EQ(s.pointClass.size(), n);
  ASSERT_EQ(s.instance.size(), n);
  ASSERT_EQ(s.heightAboveGround.size(), n);
  ASSERT_EQ(s.memberBegin.size(), static_cast<std::size_t>(s.instanceCount) + 1);
  for (std::size_t i = 0; i < n; ++i) {
    const bool unused =
        s.pointClass[i] == PointClass::Invalid || s.pointClass[i] == PointClass::OutOfRange;
    ASSERT_EQ(scan.image.row[i] == RangeImage::kNoRow, unused);
    ASSERT_EQ(s.instance[i] > 0, s.pointClass[i] == PointClass::Instance);
    if (s.pointClass[i] == PointClass::Ground) {
      ASSERT_LT(s.heightAboveGround[i], 0.11f);
    }
  }
  for (std::int32_t k = 1; k <= s.instanceCount; ++k) {
    const auto first = static_cast<std::size_t>(s.memberBegin[static_cast<std::size_t>(k) - 1]);
    const auto last = static_cast<std::size_t>(s.memberBegin[static_cast<std::size_t>(k)]);
    ASSERT_LT(first, last) << "instance " << k << " is empty";
    for (std::size_t m = first; m < last; ++m) {
      ASSERT_EQ(s.instance[static_cast<std::size_t>(s.members[m])], k);
    }
  }
}

TEST(Segmenter, EveryReturnOfARealScanHasOneClass) {
  TOSS_NEED_REAL_DATA(KittiSequence::folder());
  const KittiSequence sequence;
  Segmenter segmenter({}, {}, {}, sensorByName("HDL-64E"));
  SegmentedScan result;
  for (const std::size_t number : {0u, 42u, 99u}) {
    PosedScan scan;
    scan.points = sequence.points(number);
    scan.mapFromSensor = sequence.mapFromSensor(number);
    segmenter.segment(scan, result);
    expectConsistent(result, scan.points.size());
    EXPECT_GT(result.segmentation.instanceCount, 50);
    EXPECT_GT(segmenter.times().ground, 0.0);
  }
}

TEST(Segmenter, APersonOnASlopeIsOneInstance) {
  GroundTestScene scene;
  scene.addGround(0.0, 0.4);
  scene.addBox({7.7, -0.25, 3.0}, {8.1, 0.25, 4.9}, GroundTestScene::Object);
  const SensorModel& sensor = sensorByName("OS0-128");
  const auto scan = scene.scan(sensor, sensorAt({0, 0, 0.6}, 0.0, -0.38), sensor.columns);
  Segmenter segmenter({}, {}, {}, sensor);
  SegmentedScan result;
  segmenter.segment(scan.posed, result);
  expectConsistent(result, scan.surface.size());
  std::vector<std::int32_t> instances;
  for (std::size_t i = 0; i < scan.surface.size(); ++i) {
    if (scan.surface[i] == GroundTestScene::Object) {
      instances.push_back(result.segmentation.instance[i]);
    }
  }
  ASSERT_GT(instances.size(), 100u);
  const auto most = std::count(instances.begin(), instances.end(), instances.front());
  EXPECT_GT(static_cast<double>(most), 0.9 * static_cast<double>(instances.size()));
  EXPECT_GT(instances.front(), 0);
}

TEST(Segmenter, AnEmptyScanIsFine) {
  Segmenter segmenter({}, {}, {}, sensorByName("VLP-16"));
  SegmentedScan result;
  segmenter.segment(PosedScan{}, result);
  expectConsistent(result, 0);
  EXPECT_EQ(result.segmentation.instanceCount, 0);
}

}  // namespace
}  // namespace toss::test
