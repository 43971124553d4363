// SPDX-License-Identifier: BSD-3-Clause
#include "GpsPath.h"

#include <mrpt/obs/CObservationGPS.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/poses/CPose3D.h>
#include <toss/geometry/Error.h>
#include <toss/rawlog/MrptConversion.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "RawlogReader.h"

namespace toss {
namespace {

using Eigen::Vector3d;
using mrpt::obs::CObservationGPS;

constexpr double kRadians = M_PI / 180.0;
/// Way over which a course is measured [m]: errors of a receiver change by decimetres meanwhile.
constexpr double kStretch = 3.0;

Vector3d earthCentred(const Vector3d& geodetic) {
  constexpr double kEquator = 6378137.0, kFlattening = 1.0 / 298.257223563;
  constexpr double kEccentricity = kFlattening * (2.0 - kFlattening);
  const double latitude = kRadians * geodetic.x(), longitude = kRadians * geodetic.y();
  const double sine = std::sin(latitude);
  const double normal = kEquator / std::sqrt(1.0 - kEccentricity * sine * sine);
  const double horizontal = (normal + geodetic.z()) * std::cos(latitude);
  return {horizontal * std::cos(longitude), horizontal * std::sin(longitude),
          (normal * (1.0 - kEccentricity) + geodetic.z()) * sine};
}

/// Latitude and longitude [degrees], height [m]; none without a fix.
std::optional<Vector3d> geodeticOf(const CObservationGPS& gps) {
  using mrpt::obs::gnss::Message_NMEA_GGA;
  using mrpt::obs::gnss::Message_NMEA_RMC;
  Vector3d result;
  if (gps.hasMsgClass<Message_NMEA_GGA>()) {
    const auto& fix = gps.getMsgByClass<Message_NMEA_GGA>().fields;
    if (fix.fix_quality == 0) return std::nullopt;
    result << fix.latitude_degrees, fix.longitude_degrees, fix.altitude_meters;
  } else if (gps.hasMsgClass<Message_NMEA_RMC>()) {
    const auto& fix = gps.getMsgByClass<Message_NMEA_RMC>().fields;
    if (fix.validity_char != 'A') return std::nullopt;
    result << fix.latitude_degrees, fix.longitude_degrees, 0.0;
  } else {
    return std::nullopt;
  }
  if (!result.allFinite() || std::abs(result.x()) > 90.0) return std::nullopt;
  return result;
}

/// Where the way is a stretch farther than at the one before, and the course there.
struct Waypoint {
  Vector3d position;
  double course = 0.0;
};

std::vector<Waypoint> waypointsOf(const std::vector<GpsFix>& fixes) {
  std::vector<Waypoint> way;
  for (const GpsFix& fix : fixes)
    if (way.empty() || (fix.position - way.back().position).head<2>().norm() >= kStretch)
      way.push_back({fix.position});
  for (std::size_t i = 0; way.size() > 1 && i < way.size(); ++i) {
    const Vector3d& behind = way[i == 0 ? 0 : i - 1].position;
    const Vector3d step = way[std::min(i + 1, way.size() - 1)].position - behind;
    way[i].course = std::atan2(step.y(), step.x());
  }
  return way;
}

/// The course at a position between two waypoints.
double courseAt(const Vector3d& position, const Waypoint& from, const Waypoint& to) {
  const double length = (to.position - from.position).head<2>().norm();
  const double share = (position - from.position).head<2>().norm() / length;
  return from.course + std::min(share, 1.0) * std::remainder(to.course - from.course, 2.0 * M_PI);
}

}  // namespace

Vector3d eastNorthUp(const Vector3d& geodetic, const Vector3d& origin) {
  const double latitude = kRadians * origin.x(), longitude = kRadians * origin.y();
  const Vector3d up(std::cos(latitude) * std::cos(longitude),
                    std::cos(latitude) * std::sin(longitude), std::sin(latitude));
  const Vector3d east(-std::sin(longitude), std::cos(longitude), 0.0);
  const Vector3d offset = earthCentred(geodetic) - earthCentred(origin);
  return {east.dot(offset), up.cross(east).dot(offset), up.dot(offset)};
}

std::vector<GpsFix> readGpsFixes(const std::filesystem::path& rawlog) {
  std::vector<GpsFix> fixes;
  std::optional<Vector3d> origin;
  const auto take = [&](const mrpt::serialization::CSerializable::Ptr& object) {
    const auto gps = std::dynamic_pointer_cast<CObservationGPS>(object);
    if (!gps || gps->timestamp == INVALID_TIMESTAMP) return;
    const std::optional<Vector3d> geodetic = geodeticOf(*gps);
    if (!geodetic) return;
    if (!origin) origin = geodetic;
    fixes.push_back({gps->timestamp.time_since_epoch().count(), eastNorthUp(*geodetic, *origin),
                     fromMrpt(gps->sensorPose).translation()});
  };
  RawlogReader reader(rawlog);
  // Damage is told by whoever reads the log for its scans.
  const auto next = [&]() -> mrpt::serialization::CSerializable::Ptr {
    try {
      return reader.next();
    } catch (const UserError&) {
      return nullptr;
    }
  };
  while (const auto object = next())
    if (const auto frame = std::dynamic_pointer_cast<mrpt::obs::CSensoryFrame>(object))
      for (const auto& entry : *frame) take(entry);
    else
      take(object);
  std::stable_sort(fixes.begin(), fixes.end(),
                   [](const GpsFix& a, const GpsFix& b) { return a.time < b.time; });
  return fixes;
}

std::vector<std::pair<std::int64_t, Eigen::Isometry3d>> posesAlong(
    const std::vector<GpsFix>& fixes) {
  const std::vector<Waypoint> way = waypointsOf(fixes);
  std::vector<std::pair<std::int64_t, Eigen::Isometry3d>> poses;
  if (way.size() < 3) return poses;
  std::size_t last = 0;
  for (const GpsFix& fix : fixes) {
    if (last + 1 < way.size() && fix.position == way[last + 1].position) ++last;
    const double course =
        last + 1 < way.size() ? courseAt(fix.position, way[last], way[last + 1]) : way[last].course;
    Eigen::Isometry3d mapFromRobot = Eigen::Isometry3d::Identity();
    mapFromRobot.linear() = Eigen::AngleAxisd(course, Vector3d::UnitZ()).toRotationMatrix();
    mapFromRobot.translation() = fix.position - mapFromRobot.linear() * fix.onRobot;
    poses.emplace_back(fix.time, mapFromRobot);
  }
  return poses;
}

}  // namespace toss
