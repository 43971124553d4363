// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <filesystem>
#include <utility>
#include <vector>

namespace toss {

/// A position of a satellite receiver's antenna.
struct GpsFix {
  /// MRPT's ticks of 100 ns.
  std::int64_t time = 0;
  /// East, north, up of the first fix [m].
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  /// The antenna's place on the robot [m].
  Eigen::Vector3d onRobot = Eigen::Vector3d::Zero();
};

/// East, north, up [m] of a point against another one on the WGS 84 ellipsoid, both as latitude and
/// longitude [degrees] and height [m]: through earth-centred coordinates.
Eigen::Vector3d eastNorthUp(const Eigen::Vector3d& geodetic, const Eigen::Vector3d& origin);

/// The fixes of a rawlog (CObservationGPS with GGA, else RMC, which has no height), in order of
/// time. Throws UserError where the file can't be read.
std::vector<GpsFix> readGpsFixes(const std::filesystem::path& rawlog);

/// Level poses of the robot (map <- robot, x east, y north) that look along the path: the course
/// between stretches of 3 m, in proportion to the way in between, so that it stays while the robot
/// stands. Empty where the path is shorter than two such stretches: it has no course.
std::vector<std::pair<std::int64_t, Eigen::Isometry3d>> posesAlong(
    const std::vector<GpsFix>& fixes);

}  // namespace toss
