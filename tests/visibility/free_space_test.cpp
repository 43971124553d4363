// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <toss/visibility/CellThinning.h>
#include <toss/visibility/FreeSpaceWitness.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <random>
#include <set>

#include "AnalyticScene.h"

namespace toss {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

const AlignedBox3d kWall(Vector3d(20, -15, -5), Vector3d(21, 15, 8));

/// The sensor is parallel to the map: its frame is the level frame.
PointCloud inSensorFrame(const LevelPoints& points) {
  PointCloud cloud;
  cloud.x = points.x, cloud.y = points.y, cloud.z = points.z;
  return cloud;
}

/// Fills members and memberBegin from the instances 1 and 2 of the points.
void groupMembers(Segmentation& segmentation) {
  const auto member = [&] { return static_cast<std::int32_t>(segmentation.members.size()); };
  for (const std::int32_t k : {1, 2}) {
    segmentation.memberBegin.push_back(member());
    for (std::size_t p = 0; p < segmentation.instance.size(); ++p)
      if (segmentation.instance[p] == k)
        segmentation.members.push_back(static_cast<std::int32_t>(p));
  }
  segmentation.memberBegin.push_back(member());
}

/// Instance 1 is what `isObject` says [map frame], instance 2 all the rest.
Segmentation splitBy(const std::function<bool(const Vector3d&)>& isObject, const Vector3d& from,
                     const LevelPoints& points) {
  Segmentation result;
  result.instanceCount = 2;
  result.pointClass.assign(points.x.size(), PointClass::Instance);
  for (std::size_t p = 0; p < points.x.size(); ++p)
    result.instance.push_back(isObject(from + Vector3d(points.x[p], points.y[p], points.z[p])) ? 1
                                                                                               : 2);
  groupMembers(result);
  return result;
}

/// Ten scans a second for `seconds` of what `scene(t)` shows; instance 1 is what `isObject` says.
std::vector<EvidenceCells> run(const std::function<AnalyticScene(double)>& scene,
                               const std::function<bool(const Vector3d&)>& isObject, double seconds,
                               const std::function<Vector3d(double)>& position,
                               std::vector<FreeSpaceSum>* past = nullptr) {
  const VisibilityOptions options;
  FreeSpaceWitness witness(options);
  CellThinning thinning(options.cellSize, options.maxCells);
  std::vector<EvidenceCells> complete;
  const auto take = [&](bool all) {
    for (EvidenceCells& cells : witness.takeComplete(all)) complete.push_back(std::move(cells));
  };
  for (int i = 0; i < static_cast<int>(seconds * 10); ++i) {
    const double t = 0.1 * i;
    const Vector3d from = position(t);
    LevelPoints points;
    const RangeImage image = scene(t).look(from, points);
    EvidenceCells cells;
    thinning.thin(points, splitBy(isObject, from, points), cells);
    witness.add(t, image, inSensorFrame(points), Eigen::Isometry3d(Eigen::Translation3d(from)),
                std::move(cells));
    if (past != nullptr)
      past->push_back(sumByInstance(witness.latest(), 2, options.minFreeViews)[1]);
    take(false);
  }
  take(true);
  return complete;
}

Vector3d standing(double) {
  return Vector3d::Zero();
}
Vector3d driving(double t) {
  return {0.0, 2.0 * t - 4.0, 0.0};
}

FreeSpaceSum objectSum(const EvidenceCells& cells) {
  return sumByInstance(cells, 2, VisibilityOptions().minFreeViews)[1];
}
FreeSpaceSum wallSum(const EvidenceCells& cells) {
  return sumByInstance(cells, 2, VisibilityOptions().minFreeViews)[2];
}

bool beforeWall(const Vector3d& p) {
  return p.x() < 19.0;
}

AnalyticScene boxBetween(double t, double from, double to) {
  AnalyticScene scene;
  scene.add(kWall);
  if (t >= from && t < to) scene.add(AlignedBox3d(Vector3d(10, -1, -1.5), Vector3d(12, 1, 1)));
  return scene;
}

TEST(FreeSpace, ABoxThatArrivesIsFreeByPastViews) {
  std::vector<FreeSpaceSum> past;
  const auto cells =
      run([](double t) { return boxBetween(t, 4.0, 99.0); }, beforeWall, 6.0, standing, &past);
  ASSERT_EQ(60u, cells.size());
  const FreeSpaceSum justArrived = past[41];
  ASSERT_GT(justArrived.cells, 20);
  EXPECT_GT(justArrived.freeShare(), 0.8);
  EXPECT_LT(wallSum(cells[41]).freeShare(), 0.01);
}

TEST(FreeSpace, ABoxThatLeavesIsFreeByLaterViewsOnly) {
  std::vector<FreeSpaceSum> past;
  const auto cells =
      run([](double t) { return boxBetween(t, -1.0, 4.0); }, beforeWall, 9.0, standing, &past);
  EXPECT_EQ(0, past[38].free);
  EXPECT_GT(objectSum(cells[38]).freeShare(), 0.8);
}

TEST(FreeSpace, ABoxThatStandsIsNeverFree) {
  for (const auto& position : {std::function(standing), std::function(driving)}) {
    const auto cells =
        run([](double t) { return boxBetween(t, -1.0, 99.0); }, beforeWall, 5.0, position);
    for (const EvidenceCells& scan : cells) {
      EXPECT_LT(objectSum(scan).freeShare(), 0.02);
      EXPECT_GT(objectSum(scan).hitShare(), 0.5);
    }
  }
}

TEST(FreeSpace, APoleBeforeAFarWallIsNotSeenThroughFromAMovingSensor) {
  const auto scene = [](double) {
    AnalyticScene s;
    s.add(kWall);
    s.add(AlignedBox3d(Vector3d(9, -0.1, -2), Vector3d(9.2, 0.1, 3)));
    return s;
  };
  for (const EvidenceCells& scan : run(scene, beforeWall, 5.0, driving))
    EXPECT_LT(objectSum(scan).freeShare(), 0.1);
}

TEST(FreeSpace, AFenceIsNotSeenThroughAlthoughMostBeamsPassIt) {
  const auto scene = [](double) {
    AnalyticScene s;
    s.add(kWall);
    // Slats of 4 cm every 12 cm: two beams of three pass between them.
    for (double y = -4.0; y < 4.0; y += 0.12)
      s.add(AlignedBox3d(Vector3d(8, y, -1.5), Vector3d(8.03, y + 0.04, 0.5)));
    return s;
  };
  for (const EvidenceCells& scan : run(scene, beforeWall, 5.0, driving))
    EXPECT_LT(objectSum(scan).freeShare(), 0.1);
}

TEST(FreeSpace, WhatPassesBehindAFenceIsGlimpsedPastAndTheWallBehindItIsNot) {
  const auto scene = [](double t) {
    AnalyticScene s;
    s.add(kWall);
    for (double y = -6.0; y < 6.0; y += 0.12)
      s.add(AlignedBox3d(Vector3d(8, y, -1.5), Vector3d(8.03, y + 0.04, 1.5)));
    const double y = 1.5 * t - 4.0;
    s.add(AlignedBox3d(Vector3d(11, y, -1.5), Vector3d(11.5, y + 0.6, 0.5)));
    return s;
  };
  const auto behindFence = [](const Vector3d& p) { return p.x() > 10.0 && p.x() < 19.0; };
  const auto cells = run(scene, behindFence, 5.0, standing);
  const auto wall = [](const Vector3d& p) { return p.x() > 19.0; };
  EXPECT_LT(objectSum(cells[25]).freeShare() * objectSum(cells[25]).cells, 2.0);
  EXPECT_GT(objectSum(cells[25]).glimpsedShare(), 0.6);
  EXPECT_LT(objectSum(run(scene, wall, 5.0, standing)[25]).glimpsedShare(), 0.02);
}

TEST(FreeSpace, AFloorAtAGrazingAngleIsNotGlimpsedPast) {
  AnalyticScene floor;
  floor.add(AlignedBox3d(Vector3d(-90, -90, -1.85), Vector3d(90, 90, -1.8)));
  const auto far = [](const Vector3d& p) { return p.x() > 15.0 && std::fabs(p.y()) < 6.0; };
  const auto ahead = [](double t) { return Vector3d(1.5 * t, 0, 0); };
  const auto cells = run([&](double) { return floor; }, far, 5.0, ahead);
  ASSERT_GT(objectSum(cells[25]).cells, 20);
  int most = 0;
  for (const EvidenceCells& scan : cells) most = std::max(most, objectSum(scan).glimpsed);
  EXPECT_EQ(0, most);
}

/// A box before the wall that is `y` [m] to the left, seen through a frame of bars near the sensor.
AnalyticScene behindBars(double y) {
  AnalyticScene scene;
  scene.add(kWall);
  for (double bar = -8.0; bar < 8.0; bar += 0.09)
    scene.add(AlignedBox3d(Vector3d(2.5, bar, -1.5), Vector3d(2.52, bar + 0.02, 1.5)));
  scene.add(AlignedBox3d(Vector3d(11, y - 1.0, -1.5), Vector3d(12, y + 1.0, 1)));
  return scene;
}

TEST(FreeSpace, WhatPassesFarBehindBarsIsSeenThroughAndWhatStandsThereIsNot) {
  const auto behindFrame = [](const Vector3d& p) { return p.x() > 10.0 && p.x() < 19.0; };
  const auto moved =
      run([](double t) { return behindBars(2.0 * t - 5.0); }, behindFrame, 5.0, standing);
  ASSERT_GT(objectSum(moved[25]).cells, 20);
  EXPECT_GT(objectSum(moved[25]).freeShare(), 0.6);
  for (const EvidenceCells& scan :
       run([](double) { return behindBars(0.0); }, behindFrame, 5.0, driving))
    EXPECT_LT(objectSum(scan).freeShare(), 0.05);
}

/// Drives ahead with `speed` [m/s] for 5 s: no cell of the object may ever be free.
void expectNeverFree(const AnalyticScene& scene,
                     const std::function<bool(const Vector3d&)>& isObject, double speed) {
  const auto ahead = [speed](double t) { return Vector3d(speed * t, 0, 0); };
  const auto scans = run([&](double) { return scene; }, isObject, 5.0, ahead);
  ASSERT_GT(objectSum(scans[25]).cells, 20);
  int most = 0;
  for (const EvidenceCells& cells : scans) most = std::max(most, objectSum(cells).free);
  EXPECT_EQ(0, most);
}

TEST(FreeSpace, AShoreBehindWaterThatReturnsNothingIsNotSeenThrough) {
  AnalyticScene shore;
  shore.add(AlignedBox3d(Vector3d(18, -30, -1.85), Vector3d(90, 30, -1.8)));
  expectNeverFree(
      shore, [](const Vector3d& p) { return p.x() < 24.0; }, 1.5);
}

TEST(FreeSpace, ACeilingAtTheUpperEdgeOfTheViewIsNotSeenThrough) {
  AnalyticScene hall;
  hall.add(AlignedBox3d(Vector3d(-50, -30, 20), Vector3d(150, 30, 20.1)));
  hall.add(AlignedBox3d(Vector3d(150, -90, -9), Vector3d(151, 90, 20)));
  const auto patch = [](const Vector3d& p) { return p.z() > 19.9 && p.x() > 58.0 && p.x() < 64.0; };
  expectNeverFree(hall, patch, 2.6);
}

TEST(FreeSpace, AFloorBehindACarThatIsLookedOverIsNotSeenThrough) {
  AnalyticScene street;
  street.add(AlignedBox3d(Vector3d(-90, -90, -1.85), Vector3d(120, 90, -1.8)));
  street.add(AlignedBox3d(Vector3d(12, -2, -1.8), Vector3d(14, 2, -0.5)));
  expectNeverFree(
      street, [](const Vector3d& p) { return p.x() > 20.0 && std::fabs(p.y()) < 12.0; }, 2.0);
}

TEST(FreeSpace, FoliageIsNotSeenThroughAsAWhole) {
  const auto scene = [](double) {
    AnalyticScene s;
    s.add(kWall);
    // A lattice of leaves that fills an eighth of the volume.
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 6; ++j)
        for (int k = 0; k < 6; ++k) {
          const Vector3d leaf(9 + 0.2 * i, -1 + 0.2 * j + 0.07 * (k % 3), -1 + 0.2 * k);
          s.add(AlignedBox3d(leaf, leaf + Vector3d::Constant(0.1)));
        }
    return s;
  };
  for (const EvidenceCells& scan : run(scene, beforeWall, 3.0, driving))
    EXPECT_LT(objectSum(scan).freeShare(), 0.2);
}

TEST(FreeSpace, FarFromTheOriginNothingChanges) {
  const Vector3d far(500000.0, -4000000.0, 300.0);
  const VisibilityOptions options;
  RangeImage image;
  LevelPoints points;
  image = boxBetween(0, -1, 9).look(Vector3d::Zero(), points);
  std::vector<std::uint8_t> free(points.x.size(), 0), hits(points.x.size(), 0),
      glimpses(points.x.size(), 0);
  RangeView view(options);
  RangeView::Scratch scratch;
  view.look(image, inSensorFrame(points), Eigen::Isometry3d(Eigen::Translation3d(far)), scratch);
  view.testify(points.x.data(), points.y.data(), points.z.data(), points.x.size(), far, free.data(),
               hits.data(), glimpses.data());
  for (std::size_t i = 0; i < hits.size(); ++i) EXPECT_EQ(1, hits[i]);
}

/// Points at random: a quarter each unclustered, of instance 1, of instance 2, and ground.
Segmentation randomSegmentation(std::mt19937& random, LevelPoints& points, int count) {
  std::uniform_real_distribution<float> place(-9.0f, 9.0f);
  Segmentation result;
  result.instanceCount = 2;
  for (int p = 0; p < count; ++p) {
    points.x.push_back(place(random)), points.y.push_back(place(random));
    points.z.push_back(0.1f * place(random));
    const int kind = static_cast<int>(random() % 4);
    result.instance.push_back(kind < 3 ? kind : 0);
    result.pointClass.push_back(kind == 0   ? PointClass::Unclustered
                                : kind == 3 ? PointClass::Ground
                                            : PointClass::Instance);
  }
  groupMembers(result);
  return result;
}

TEST(CellThinning, KeepsTheFirstReturnOfEachCellAndASampleOfLargeInstances) {
  std::mt19937 random(4);
  LevelPoints points;
  const Segmentation segmentation = randomSegmentation(random, points, 4000);
  constexpr double kCellSize = 0.5;
  constexpr std::size_t kMaxCells = 100;
  // By the definition: a map from cell to first return, per group in order of their coming.
  using Key = std::array<int, 3>;
  std::array<std::map<Key, std::size_t>, 3> cellOf;
  std::array<std::vector<std::size_t>, 3> first;
  std::vector<std::size_t> loneCells;
  const auto axis = [](float v) { return static_cast<int>(std::floor(v / kCellSize)); };
  for (std::size_t p = 0; p < points.x.size(); ++p) {
    if (segmentation.pointClass[p] == PointClass::Ground) continue;
    const auto k = static_cast<std::size_t>(segmentation.instance[p]);
    const Key key{axis(points.x[p]), axis(points.y[p]), axis(points.z[p])};
    const auto [place, isNew] = cellOf[k].try_emplace(key, first[k].size());
    if (isNew) first[k].push_back(p);
    if (k == 0) loneCells.push_back(place->second);
  }
  std::vector<float> expected;
  for (const std::size_t k : {0, 1, 2}) {
    const std::size_t stride = k == 0 ? 1 : 1 + (first[k].size() - 1) / kMaxCells;
    for (std::size_t c = 0; c < first[k].size(); c += stride)
      expected.push_back(points.x[first[k][c]]);
  }
  EvidenceCells cells;
  CellThinning(kCellSize, kMaxCells).thin(points, segmentation, cells);
  EXPECT_EQ(expected, cells.x);
  ASSERT_EQ(loneCells.size(), cells.loneCell.size());
  for (std::size_t i = 0; i < loneCells.size(); ++i)
    EXPECT_EQ(loneCells[i], static_cast<std::size_t>(cells.loneCell[i]));
}

TEST(CellThinning, NothingIsAskedAboutWhatFloats) {
  // Of each instance, and of what is in none, a return at 1 m and one at 4 m above ground.
  LevelPoints points;
  Segmentation segmentation;
  const auto add = [&](std::int32_t instance, float x, float height) {
    points.x.push_back(x), points.y.push_back(5.0f), points.z.push_back(height - 1.7f);
    segmentation.instance.push_back(instance);
    segmentation.pointClass.push_back(instance > 0 ? PointClass::Instance
                                                   : PointClass::Unclustered);
    segmentation.heightAboveGround.push_back(height);
  };
  segmentation.instanceCount = 2;
  add(0, 1.0f, 1.0f), add(0, 3.0f, 4.0f);
  add(1, 5.0f, 1.0f), add(1, 7.0f, 4.0f);
  add(2, 9.0f, 3.5f), add(2, 11.0f, 4.0f);
  groupMembers(segmentation);
  EvidenceCells cells;
  CellThinning(0.2, 48, 2.5).thin(points, segmentation, cells);
  EXPECT_EQ((std::vector<float>{1.0f, 5.0f, 7.0f}), cells.x);
  EXPECT_EQ((std::vector<std::int32_t>{0, 1, 1}), cells.instance);
  EXPECT_EQ(std::vector<std::int32_t>{0}, cells.lonePoint);
  CellThinning(0.2, 48).thin(points, segmentation, cells);
  EXPECT_EQ(6u, cells.size());
}

TEST(EvidenceCells, WhatIsFoundToFloatLaterWasNotSeenThrough) {
  // Squares along x: ground 2 m below the sensor from 0 on, none before.
  NearbyGround ground;
  ground.assign(64.0, [](std::int64_t row, std::int64_t) {
    return row >= 0 ? -2.0f : std::numeric_limits<float>::infinity();
  });
  EvidenceCells cells;
  const auto add = [&](std::int32_t instance, float x, float z,
                       float known = std::numeric_limits<float>::quiet_NaN()) {
    cells.instance.push_back(instance);
    cells.x.push_back(x), cells.y.push_back(0.0f), cells.z.push_back(z);
    cells.heightAboveGround.push_back(known);
  };
  add(0, 5.0f, 2.0f), add(0, 5.0f, -1.0f);             // Lone: high, low.
  add(1, 5.0f, 2.0f), add(1, 6.0f, 3.0f);              // A crown.
  add(2, 5.0f, 2.0f), add(2, 6.0f, -1.5f);             // A tree.
  add(3, 5.0f, 2.0f, 1.0f), add(3, 6.0f, 3.0f, 2.0f);  // On a terrace known when it was seen.
  add(4, -60.0f, 2.0f), add(4, -60.0f, 3.0f);          // Too far from any ground.
  for (Testimony* each : {&cells.past, &cells.later}) {
    each->reset(cells.size());
    each->freeViews.assign(cells.size(), 3), each->hitViews.assign(cells.size(), 1);
    each->glimpseViews.assign(cells.size(), 2);
  }
  silenceFloating(ground, 2.5f, cells);
  const std::vector<std::uint8_t> kFree{0, 3, 0, 0, 3, 3, 3, 3, 3, 3},
      kGlimpsed{0, 2, 0, 0, 2, 2, 2, 2, 2, 2};
  for (const Testimony* each : {&cells.past, &cells.later}) {
    EXPECT_EQ(kFree, each->freeViews);
    EXPECT_EQ(kGlimpsed, each->glimpseViews);
    EXPECT_EQ(std::vector<std::uint8_t>(cells.size(), 1), each->hitViews);
  }
}

TEST(CellThinning, CellsOfAHugeInstanceAreSpreadOverIt) {
  constexpr std::size_t kMaxCells = 40;
  constexpr double kCellSize = 0.5;
  LevelPoints wall;
  Segmentation segmentation;
  segmentation.instanceCount = 1;
  // Row after row as a scan brings them: 50 rows of a wall of 40 m.
  for (int row = 0; row < 50; ++row)
    for (int column = 0; column < 400; ++column) {
      wall.x.push_back(0.1f * static_cast<float>(column) + 0.05f), wall.y.push_back(7.0f);
      wall.z.push_back(0.04f * static_cast<float>(row) + 0.02f);
      segmentation.instance.push_back(1);
      segmentation.pointClass.push_back(PointClass::Instance);
    }
  groupMembers(segmentation);
  EvidenceCells cells;
  CellThinning(kCellSize, kMaxCells).thin(wall, segmentation, cells);
  EXPECT_LE(cells.size(), kMaxCells);
  EXPECT_GT(cells.size(), kMaxCells / 2);
  std::set<std::pair<int, int>> places;
  std::array<int, 4> inQuarter{};
  for (std::size_t c = 0; c < cells.size(); ++c) {
    places.emplace(std::floor(cells.x[c] / kCellSize), std::floor(cells.z[c] / kCellSize));
    ++inQuarter[static_cast<std::size_t>(cells.x[c] / 10.0f)];
  }
  EXPECT_EQ(cells.size(), places.size());
  for (const int count : inQuarter) EXPECT_GT(count, static_cast<int>(cells.size()) / 8);
}

}  // namespace
}  // namespace toss
