// SPDX-License-Identifier: BSD-3-Clause
// What a perfect classifier of instances could still get right on real scans (spec section 11).
#include <gtest/gtest.h>
#include <toss/segmentation/Segmenter.h>

#include "RealScans.h"

namespace toss::test {
namespace {

/// Counts over all scans; only points with a label count as moving or static.
struct Bounds {
  int aboveGround = 0, inInstances = 0;
  int moving = 0, movingWithoutInstance = 0, movingAmongStatic = 0;
  int fixed = 0, fixedAmongMoving = 0;
  int instances = 0;
};

/// KITTI labels: 0 = unknown, from 252 on moving.
constexpr std::uint32_t kFirstMoving = 252;

std::vector<bool> findMovingInstances(const Segmentation& result,
                                      const std::vector<std::uint32_t>& labels) {
  std::vector<bool> moves(static_cast<std::size_t>(result.instanceCount) + 1, false);
  for (std::size_t k = 1; k < moves.size(); ++k) {
    int balance = 0;
    for (std::int32_t m = result.memberBegin[k - 1]; m < result.memberBegin[k]; ++m) {
      const auto point = static_cast<std::size_t>(result.members[static_cast<std::size_t>(m)]);
      const std::uint32_t label = labels[point] & 0xFFFF;
      if (label != 0) balance += label >= kFirstMoving ? 1 : -1;
    }
    moves[k] = balance > 0;
  }
  return moves;
}

void count(const Segmentation& result, const std::vector<std::uint32_t>& labels, Bounds& bounds) {
  const std::vector<bool> moves = findMovingInstances(result, labels);
  bounds.instances += result.instanceCount;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const bool inInstance = result.pointClass[i] == PointClass::Instance;
    const bool unclustered = result.pointClass[i] == PointClass::Unclustered;
    const bool amongMoving = moves[static_cast<std::size_t>(result.instance[i])];
    bounds.inInstances += inInstance;
    bounds.aboveGround += inInstance || unclustered;
    const std::uint32_t label = labels[i] & 0xFFFF;
    if (label >= kFirstMoving) {
      ++bounds.moving;
      bounds.movingWithoutInstance += !inInstance;
      bounds.movingAmongStatic += inInstance && !amongMoving;
    } else if (label != 0) {
      ++bounds.fixed;
      bounds.fixedAmongMoving += amongMoving;
    }
  }
}

Bounds measure(const ObjectOptions& options, std::size_t step) {
  const KittiSequence sequence;
  Segmenter segmenter(ProjectionOptions{}, GroundOptions{}, options, sensorByName("HDL-64E"));
  SegmentedScan segmented;
  Bounds bounds;
  for (std::size_t scan = 0; scan < sequence.size(); scan += step) {
    PosedScan posed;
    posed.points = sequence.points(scan);
    posed.mapFromSensor = sequence.mapFromSensor(scan);
    segmenter.segment(posed, segmented);
    count(segmented.segmentation, sequence.labels(scan), bounds);
  }
  return bounds;
}

TEST(ObjectsOfRealScans, LeaveNearlyAllMoversToTheClassifier) {
  TOSS_NEED_REAL_DATA(KittiSequence::folder());
  const Bounds bounds = measure(ObjectOptions{}, 20);
  ASSERT_GT(bounds.moving, 1000);
  EXPECT_GT(bounds.inInstances, 0.99 * bounds.aboveGround);
  EXPECT_LT(bounds.movingWithoutInstance, 0.005 * bounds.moving);
  EXPECT_LT(bounds.movingAmongStatic, 0.005 * bounds.moving);
  EXPECT_LT(bounds.fixedAmongMoving, 0.0005 * bounds.fixed);
}

TEST(ObjectsOfRealScans, ReachMoreMoversThanTheReferenceBehaviour) {
  TOSS_NEED_REAL_DATA(KittiSequence::folder());
  ObjectOptions reference;
  reference.metric = LinkMetric::Constant;
  reference.minPointsNear = reference.minPointsFar = 10;
  reference.maxPoints = 30000;
  reference.surfaceDistance = reference.attachDistance = reference.splitExtent = 0.0;
  const Bounds theirs = measure(reference, 50), ours = measure(ObjectOptions{}, 50);
  EXPECT_LT(2 * ours.movingWithoutInstance, theirs.movingWithoutInstance);
  EXPECT_GT(ours.inInstances, theirs.inInstances);
}

}  // namespace
}  // namespace toss::test
