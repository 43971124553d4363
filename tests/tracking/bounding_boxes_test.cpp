// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <toss/geometry/Error.h>
#include <toss/tracking/BoundingBoxes.h>

#include <cmath>
#include <limits>

namespace toss {
namespace {

/// Points by instance, as segmentation would hand them over.
struct Instances {
  LevelPoints points;
  Segmentation segmentation;

  Instances() { segmentation.memberBegin = {0}; }

  void begin() {
    ++segmentation.instanceCount;
    segmentation.memberBegin.push_back(segmentation.memberBegin.back());
  }
  void add(double x, double y, double z, float height = std::numeric_limits<float>::quiet_NaN()) {
    segmentation.members.push_back(static_cast<std::int32_t>(points.x.size()));
    ++segmentation.memberBegin.back();
    points.x.push_back(static_cast<float>(x));
    points.y.push_back(static_cast<float>(y));
    points.z.push_back(static_cast<float>(z));
    segmentation.heightAboveGround.push_back(height);
  }

  std::vector<Detection> detect(const BoxOptions& options,
                                const Eigen::Vector3d& sensor = Eigen::Vector3d::Zero()) const {
    std::vector<Detection> result(7);
    detectInstances(points, segmentation, sensor, options, result);
    return result;
  }
};

/// Returns from the sides of an upright rectangle, 5 cm apart, at three heights; `sides`: how many
/// of its four sides are seen.
Instances rectangle(double centerX, double centerY, double yaw, double length, double width,
                    int sides) {
  Instances instances;
  instances.begin();
  const auto add = [&](double along, double across) {
    const double x = centerX + along * std::cos(yaw) - across * std::sin(yaw);
    const double y = centerY + along * std::sin(yaw) + across * std::cos(yaw);
    for (const double z : {-1.5, -1.0, -0.5}) instances.add(x, y, z);
  };
  const auto side = [&](double fromX, double fromY, double toX, double toY) {
    const int steps = static_cast<int>(std::hypot(toX - fromX, toY - fromY) / 0.05);
    for (int i = 0; i <= steps; ++i) {
      const double t = static_cast<double>(i) / steps;
      add(fromX + t * (toX - fromX), fromY + t * (toY - fromY));
    }
  };
  const double l = length / 2, w = width / 2;
  if (sides >= 1) side(-l, -w, l, -w);
  if (sides >= 2) side(-l, -w, -l, w);
  if (sides >= 3) side(l, -w, l, w);
  if (sides >= 4) side(-l, w, l, w);
  return instances;
}

BoxOptions lShape() {
  BoxOptions options;
  options.mode = BoxMode::LShape;
  return options;
}

/// Difference of two directions of a line, in [0, pi/2].
double lineAngle(double a, double b) {
  return std::abs(std::remainder(a - b, M_PI));
}

TEST(BoundingBoxes, AxisAlignedBoxIsMinimumAndMaximumInTheMap) {
  Instances instances;
  instances.begin();
  instances.add(1.0, 2.0, -1.0), instances.add(4.0, 2.5, 0.5), instances.add(2.0, 8.0, 0.0);
  const Detection d = instances.detect(BoxOptions(), {100.0, 200.0, 30.0}).at(0);
  EXPECT_TRUE(d.box.center.isApprox(Eigen::Vector3d(102.5, 205.0, 29.75), 1e-9));
  EXPECT_DOUBLE_EQ(d.box.length, 3.0);
  EXPECT_DOUBLE_EQ(d.box.width, 6.0);
  EXPECT_DOUBLE_EQ(d.box.height, 1.5);
  EXPECT_EQ(d.box.yaw, 0.0);
  EXPECT_EQ(d.pointCount, 3);
  EXPECT_EQ(d.instance, 1);
  EXPECT_FALSE(d.background);
}

TEST(BoundingBoxes, StaysExactFarFromTheMapsOrigin) {
  Instances instances;
  instances.begin();
  instances.add(1.0, 1.0, 0.0), instances.add(1.015625, 1.0, 0.0);
  const Eigen::Vector3d sensor(1.0e7, -2.0e7, 500.0);
  const Detection d = instances.detect(BoxOptions(), sensor).at(0);
  EXPECT_DOUBLE_EQ(d.box.center.x(), 1.0e7 + 1.0078125);
  EXPECT_DOUBLE_EQ(d.box.length, 0.015625);
}

TEST(BoundingBoxes, GivesOneDetectionPerInstanceInOrder) {
  Instances instances;
  for (int k = 1; k <= 4; ++k) {
    instances.begin();
    for (int i = 0; i < k; ++i) instances.add(10.0 * k, i, 0.0);
  }
  const std::vector<Detection> detections = instances.detect(BoxOptions());
  ASSERT_EQ(detections.size(), 4u);
  for (int k = 1; k <= 4; ++k) {
    EXPECT_EQ(detections[static_cast<std::size_t>(k) - 1].instance, k);
    EXPECT_EQ(detections[static_cast<std::size_t>(k) - 1].pointCount, k);
    EXPECT_DOUBLE_EQ(detections[static_cast<std::size_t>(k) - 1].box.center.x(), 10.0 * k);
  }
  EXPECT_TRUE(Instances().detect(BoxOptions()).empty());
}

TEST(BoundingBoxes, LShapeFindsRectanglesAtAnyAngle) {
  for (int degrees = -90; degrees < 90; degrees += 7) {
    const double yaw = degrees * M_PI / 180.0;
    for (int sides : {2, 3, 4}) {
      const Box box = rectangle(12.0, -5.0, yaw, 4.2, 1.8, sides).detect(lShape()).at(0).box;
      EXPECT_LT(lineAngle(box.yaw, yaw), 0.6 * M_PI / 180.0) << degrees << " " << sides;
      EXPECT_NEAR(box.length, 4.2, 0.05);
      EXPECT_NEAR(box.width, 1.8, 0.07);
      EXPECT_NEAR((box.center.head<2>() - Eigen::Vector2d(12.0, -5.0)).norm(), 0.0, 0.05);
      EXPECT_GE(box.yaw, -M_PI / 2);
      EXPECT_LT(box.yaw, M_PI / 2);
    }
  }
}

TEST(BoundingBoxes, LShapeOfOneSideLiesAlongIt) {
  for (int degrees = -90; degrees < 90; degrees += 11) {
    const double yaw = degrees * M_PI / 180.0;
    const Box box = rectangle(8.0, 3.0, yaw, 3.0, 1.5, 1).detect(lShape()).at(0).box;
    EXPECT_LT(lineAngle(box.yaw, yaw), 0.6 * M_PI / 180.0) << degrees;
    EXPECT_NEAR(box.length, 3.0, 0.01);
    EXPECT_LT(box.width, 0.05);
  }
}

TEST(BoundingBoxes, AxisAlignedBoxOfATurnedRectangleHasTheClosedForm) {
  const double yaw = M_PI / 4;
  const Box box = rectangle(0.0, 10.0, yaw, 4.2, 1.8, 4).detect(BoxOptions()).at(0).box;
  EXPECT_NEAR(box.length, (4.2 + 1.8) / std::sqrt(2.0), 1e-5);
  EXPECT_NEAR(box.width, (4.2 + 1.8) / std::sqrt(2.0), 1e-5);
}

TEST(BoundingBoxes, LShapeLeavesSmallAndSparseInstancesAxisAligned) {
  EXPECT_EQ(rectangle(5.0, 0.0, 0.5, 0.8, 0.5, 4).detect(lShape()).at(0).box.yaw, 0.0);
  BoxOptions options = lShape();
  options.lShapePoints = 100000;
  EXPECT_EQ(rectangle(5.0, 0.0, 0.5, 4.0, 2.0, 4).detect(options).at(0).box.yaw, 0.0);
}

TEST(BoundingBoxes, DegenerateInstancesHaveFiniteBoxes) {
  for (const BoxMode mode : {BoxMode::AxisAligned, BoxMode::LShape}) {
    BoxOptions options;
    options.mode = mode;
    options.lShapePoints = 3;
    options.lShapeMinSide = 0.0;
    Instances instances;
    instances.begin(), instances.add(3.0, 4.0, 0.5);
    instances.begin();
    for (int i = 0; i < 50; ++i) instances.add(3.0, 4.0, 0.5);
    instances.begin();
    for (int i = 0; i < 50; ++i) instances.add(3.0, 4.0 + 0.05 * i, 0.5);
    const std::vector<Detection> d = instances.detect(options);
    for (std::size_t k : {0u, 1u}) {
      EXPECT_TRUE(d[k].box.center.isApprox(Eigen::Vector3d(3.0, 4.0, 0.5), 1e-6));
      EXPECT_EQ(d[k].box.volume(), 0.0);
    }
    EXPECT_NEAR(d[2].box.center.y(), 4.0 + 0.05 * 24.5, 1e-5);
    EXPECT_NEAR(std::max(d[2].box.length, d[2].box.width), 0.05 * 49, 1e-5);
  }
}

TEST(BoundingBoxes, TrimCutsStraysOfLargeInstancesOnly) {
  BoxOptions options;
  options.trim = 0.01;
  for (const int n : {150, 1000}) {
    Instances instances;
    instances.begin();
    for (int i = 0; i < n; ++i) instances.add(10.0 + static_cast<double>(i) / n, 0.0, 0.0);
    instances.add(15.0, 0.0, 0.0);
    const Box box = instances.detect(options).at(0).box;
    if (n > options.trimPoints) {
      EXPECT_NEAR(box.length, 0.98, 0.005);
    } else {
      EXPECT_DOUBLE_EQ(box.length, 5.0);
    }
  }
}

TEST(BoundingBoxes, LowerFaceReachesGroundThatIsNear) {
  BoxOptions options;
  options.floorGap = 0.3;
  for (const float clearance : {0.2f, 1.2f}) {
    Instances instances;
    instances.begin();
    instances.add(5.0, 0.0, -0.5, clearance), instances.add(5.0, 1.0, 0.5, clearance + 1.0f);
    const Box box = instances.detect(options).at(0).box;
    const double bottom = clearance <= 0.3f ? -0.7 : -0.5;
    EXPECT_NEAR(box.center.z() - box.height / 2, bottom, 1e-6);
    EXPECT_NEAR(box.center.z() + box.height / 2, 0.5, 1e-6);
  }
}

/// Whether two corners of a box make it background.
bool isBackground(double length, double width, double height, float clearance = 0.1f) {
  Instances instances;
  instances.begin();
  instances.add(0.0, 0.0, 0.0, clearance);
  instances.add(length, width, height, clearance + static_cast<float>(height));
  return instances.detect(BoxOptions()).at(0).background;
}

TEST(BoundingBoxes, BackgroundIsWhatIsTooLargeToMove) {
  EXPECT_FALSE(isBackground(4.2, 1.8, 1.5));
  EXPECT_FALSE(isBackground(18.0, 3.0, 4.0)) << "a truck";
  EXPECT_FALSE(isBackground(13.0, 13.0, 3.3)) << "a bus across the map's axes";
  EXPECT_FALSE(isBackground(0.4, 0.4, 6.0)) << "thin things may be high";
  EXPECT_TRUE(isBackground(21.0, 0.5, 1.0));
  EXPECT_TRUE(isBackground(0.5, 21.0, 1.0));
  EXPECT_TRUE(isBackground(5.0, 4.0, 8.0)) << "a tree";
  EXPECT_TRUE(isBackground(2.0, 2.0, 1.0, 3.5f)) << "a crown";
  EXPECT_FALSE(isBackground(2.0, 2.0, 1.0, 2.2f)) << "what is seen of a truck over a car";
}

TEST(BoundingBoxes, RefusesOptionsOutOfRange) {
  BoxOptions options;
  options.trim = 0.7;
  EXPECT_THROW(Instances().detect(options), UserError);
}

}  // namespace
}  // namespace toss
