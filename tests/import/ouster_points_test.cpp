// SPDX-License-Identifier: BSD-3-Clause
#include <InputFixtures.h>
#include <toss/import/OusterPoints.h>

#include <cmath>

#include "OusterFixtures.h"

namespace toss::test {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double kPi = 3.14159265358979323846;

/// A frame of 512 columns that shows `range` [mm] wherever `shows(row, column)` is true.
template <typename Shows>
OusterFrame frameOf(const OusterMetadata& metadata, std::uint32_t range, Shows shows) {
  OusterFrame frame;
  frame.rows = metadata.pixelsPerColumn;
  frame.columns = metadata.columnsPerFrame;
  const auto columns = static_cast<std::size_t>(frame.columns);
  for (std::size_t c = 0; c < columns; ++c) frame.timestamp.push_back(5'000'000 + 195'312 * c);
  frame.measurementId.resize(columns);
  frame.status.assign(columns, 1);
  frame.valid.assign(columns, 1);
  for (int row = 0; row < frame.rows; ++row)
    for (int column = 0; column < frame.columns; ++column) {
      frame.returns[0].range.push_back(shows(row, column) ? range : 0);
      frame.returns[0].reflectivity.push_back(static_cast<std::uint16_t>(10 * row));
    }
  return frame;
}

class OusterPointsOf : public ::testing::Test {
 protected:
  void SetUp() override {
    nlohmann::json json = sensor.flatMetadata();
    json["beam_to_lidar_transform"] = {1, 0, 0, 27.67, 0, 1, 0, 0, 0, 0, 1, 4.0, 0, 0, 0, 1};
    TemporaryFolder folder;
    writeBytes(folder / "meta.json", json.dump());
    metadata = readOusterMetadata(folder / "meta.json");
  }

  /// The point by a chain of rigid motions instead of the manual's formula: the encoder turns the
  /// head, the beam starts ahead of its axis and leaves by its angles; ranges count from the axis.
  Vector3d expected(int row, int column, double range) const {
    const auto beam = static_cast<std::size_t>(row);
    const Isometry3d head(
        Eigen::AngleAxisd(-2.0 * kPi * column / metadata.columnsPerFrame, Vector3d::UnitZ()));
    const Vector3d start(metadata.beamOriginForward, 0.0, metadata.beamOriginUp);
    const Eigen::Matrix3d aim =
        (Eigen::AngleAxisd(-metadata.beamAzimuths[beam], Vector3d::UnitZ()) *
         Eigen::AngleAxisd(-metadata.beamAltitudes[beam], Vector3d::UnitY()))
            .toRotationMatrix();
    const Vector3d inLidar = head * (start + aim * Vector3d(range - start.norm(), 0.0, 0.0));
    return metadata.sensorFromLidar * inLidar;
  }

  FakeOuster sensor;
  OusterMetadata metadata;
};

TEST_F(OusterPointsOf, LieWhereTheBeamsLead) {
  const OusterPoints points(metadata);
  for (const int column : {0, 1, 100, 256, 511})
    for (int row = 0; row < metadata.pixelsPerColumn; ++row)
      for (const std::uint32_t range : {500u, 7300u, 120000u}) {
        PosedScan scan;
        points.toScan(
            frameOf(metadata, range, [&](int r, int c) { return r == row && c == column; }), scan);
        ASSERT_EQ(scan.points.size(), 1u);
        const Vector3d inHousing =
            scan.robotFromSensor * Vector3d(scan.points.x[0], scan.points.y[0], scan.points.z[0]);
        EXPECT_NEAR((inHousing - expected(row, column, 1e-3 * range)).norm(), 0.0, 1e-5);
      }
}

TEST_F(OusterPointsOf, ComeRingAfterRingWithGrowingAzimuth) {
  PosedScan scan;
  OusterPoints(metadata).toScan(frameOf(metadata, 20000, [](int, int) { return true; }), scan);
  const PointCloud& points = scan.points;
  ASSERT_EQ(points.size(), 8u * 512u);
  ASSERT_EQ(points.time.size(), points.size());
  float lastAzimuth = 0.0f;
  for (std::size_t i = 0; i < points.size(); ++i) {
    ASSERT_EQ(points.ring[i], i / 512);
    float azimuth = std::atan2(points.y[i], points.x[i]);
    if (azimuth < 0.0f) azimuth += static_cast<float>(2.0 * kPi);
    if (i % 512 != 0) {
      ASSERT_GT(azimuth, lastAzimuth);
    } else {
      ASSERT_LT(azimuth, 2.1 * kPi / 512);
    }
    lastAzimuth = azimuth;
    const float elevation = std::atan2(points.z[i], std::hypot(points.x[i], points.y[i]));
    ASSERT_NEAR(elevation, scan.beams->elevations[points.ring[i]], 1e-3);
  }
}

TEST_F(OusterPointsOf, HaveIntensityAndTime) {
  PosedScan scan;
  OusterFrame frame = frameOf(metadata, 20000, [](int row, int column) {
    return row == 3 && (column == 0 || column == 100);
  });
  frame.valid[0] = 0;
  OusterPoints(metadata).toScan(frame, scan);
  ASSERT_EQ(scan.points.size(), 1u);
  // The first column that was measured is number 1.
  EXPECT_NEAR(scan.points.time[0], 99 * 195'312e-9, 1e-8);
  EXPECT_NEAR(scan.points.intensity[0], 30.0 / 255.0, 1e-7);
  EXPECT_EQ(OusterPoints::timeOf(frame), 5'000'000u + 195'312u);
}

TEST_F(OusterPointsOf, IncludeSecondReturns) {
  PosedScan scan;
  OusterFrame frame = frameOf(metadata, 20000, [](int row, int) { return row == 2; });
  frame.returns[1] =
      frameOf(metadata, 30000, [](int row, int c) { return row == 2 && c == 7; }).returns[0];
  OusterPoints(metadata).toScan(frame, scan);
  ASSERT_EQ(scan.points.size(), 513u);
  int pairs = 0;
  for (std::size_t i = 1; i < scan.points.size(); ++i)
    pairs += scan.points.time[i] == scan.points.time[i - 1];
  EXPECT_EQ(pairs, 1);
}

TEST_F(OusterPointsOf, LeaveOutPixelsWithoutABeam) {
  metadata.beamActive[1] = metadata.beamActive[3] = false;
  PosedScan scan;
  OusterPoints(metadata).toScan(frameOf(metadata, 20000, [](int, int) { return true; }), scan);
  EXPECT_EQ(scan.points.size(), 6u * 512u);
  EXPECT_EQ(scan.points.ring.back(), 5);
  EXPECT_EQ(scan.beams->rows(), 6);
}

TEST_F(OusterPointsOf, NameTheModelByTheProductLine) {
  const std::vector<std::pair<std::string, std::string>> names = {{"OS-1-64", "OS1-64"},
                                                                  {"OS-0-128-U02", "OS0-128"},
                                                                  {"OS-2-32-BH02", "OS2-32"},
                                                                  {"OS-DOME-128", "OS-DOME-128"},
                                                                  {"", "Ouster-8"}};
  for (const auto& [line, name] : names) {
    metadata.productLine = line;
    EXPECT_EQ(sensorModelOf(metadata).name, name);
  }
  EXPECT_EQ(sensorModelOf(metadata).columns, 512);
}

}  // namespace
}  // namespace toss::test
