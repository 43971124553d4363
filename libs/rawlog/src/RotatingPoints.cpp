// SPDX-License-Identifier: BSD-3-Clause
// Points of a CObservationRotatingScan: a range image, whose beams the sensor's name tells.
#include <mrpt/obs/CObservationRotatingScan.h>
#include <mrpt/obs/VelodyneCalibration.h>
#include <toss/geometry/Error.h>
#include <toss/rawlog/ObservationPoints.h>
#include <toss/rawlog/SensorRecognition.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace toss {
namespace {

using mrpt::obs::CObservationRotatingScan;

constexpr double kFullTurn = 2.0 * M_PI;

/// Where the pixels of the image point to.
struct ImageGeometry {
  /// Elevation [rad] and ring of each row.
  std::vector<double> elevations;
  std::vector<std::uint16_t> rings;
  /// Azimuth of column 0, counterclockwise from ahead, and from one column to the next [rad].
  double start = 0.0, step = 0.0;
  /// Columns that the sweep takes.
  Eigen::Index columns = 0;
};

/// CObservationRotatingScan::fromVelodyne() of MRPT 2.5.8 makes an image as many times too wide as
/// it has rows, in the order of lasers, and takes the sensor's clockwise azimuths over.
bool isMadeByMrpt(const CObservationRotatingScan& scan) {
  constexpr Eigen::Index kReturnsPerPacket = 384;
  const auto& image = scan.rangeImage;
  const Eigen::Index used = image.cols() / image.rows();
  return (scan.lidarModel == "VLP-16" || scan.lidarModel == "HDL-32E") &&
         image.cols() % kReturnsPerPacket == 0 && used > 0 &&
         (image.asEigen().rightCols(image.cols() - used).array() == 0).all();
}

void setRows(const std::vector<double>& elevations, ImageGeometry& geometry) {
  geometry.elevations = elevations;
  for (const double elevation : elevations)
    geometry.rings.push_back(static_cast<std::uint16_t>(std::count_if(
        elevations.begin(), elevations.end(), [&](double other) { return other > elevation; })));
}

ImageGeometry geometryOfMrpt(const CObservationRotatingScan& scan) {
  ImageGeometry geometry;
  geometry.columns = scan.rangeImage.cols() / scan.rangeImage.rows();
  geometry.start = -scan.startAzimuth;
  geometry.step = -scan.azimuthSpan / static_cast<double>(geometry.columns);
  const char* model = scan.rangeImage.rows() == 16 ? "VLP16" : "HDL32";
  std::vector<double> elevations;
  for (const auto& laser :
       mrpt::obs::VelodyneCalibration::LoadDefaultCalibration(model).laser_corrections)
    elevations.push_back(laser.verticalCorrection * M_PI / 180.0);
  setRows(elevations, geometry);
  return geometry;
}

/// As the class documents it: rings from the top, azimuths of the first and the last column. Where
/// they are a whole turn apart, the last column lies one step before the first.
ImageGeometry geometryOf(const CObservationRotatingScan& scan, const SensorModel& sensor) {
  ImageGeometry geometry;
  geometry.columns = scan.rangeImage.cols();
  const auto count = static_cast<double>(geometry.columns);
  const bool wholeTurn = std::abs(scan.azimuthSpan) > kFullTurn * (1.0 - 0.5 / count);
  geometry.start = scan.startAzimuth;
  geometry.step = scan.azimuthSpan / std::max(1.0, wholeTurn ? count : count - 1.0);
  setRows({sensor.elevations.begin(), sensor.elevations.end()}, geometry);
  return geometry;
}

const SensorModel& sensorOf(const CObservationRotatingScan& scan, const std::string& place) {
  std::string name = sensorNamedIn(scan.lidarModel);
  if (name.empty()) name = sensorNamedIn(scan.sensorLabel);
  if (name.empty())
    throw UserError(
        place, "its range image is of sensor '" + scan.lidarModel + "', whose beams are not known",
        "name one of config/sensors in its lidarModel or sensorLabel");
  const SensorModel& sensor = sensorByName(name);
  if (scan.rangeImage.rows() != sensor.rows() || !(scan.rangeResolution > 0.0) ||
      !std::isfinite(scan.startAzimuth) || !std::isfinite(scan.azimuthSpan))
    throw UserError(place,
                    "its range image of " + std::to_string(scan.rangeImage.rows()) +
                        " rows is none of sensor " + name + ", which has " +
                        std::to_string(sensor.rows()),
                    "set lidarModel, rangeResolution and azimuths of the observation aright");
  return sensor;
}

void fillPoints(const CObservationRotatingScan& scan, const ImageGeometry& geometry,
                PointCloud& points) {
  const auto& ranges = scan.rangeImage;
  const bool bright =
      scan.intensityImage.rows() == ranges.rows() && scan.intensityImage.cols() == ranges.cols();
  points.resize(static_cast<std::size_t>(ranges.rows() * ranges.cols()));
  points.ring.resize(points.size());
  if (scan.sweepDuration > 0.0) points.time.resize(points.size());
  std::size_t i = 0;
  for (Eigen::Index row = 0; row < ranges.rows(); ++row) {
    const double elevation = geometry.elevations[static_cast<std::size_t>(row)];
    for (Eigen::Index column = 0; column < ranges.cols(); ++column, ++i) {
      const double azimuth = geometry.start + geometry.step * static_cast<double>(column);
      const double range = ranges(row, column) * scan.rangeResolution;
      const double seen = range >= scan.minRange && range <= scan.maxRange ? range : 0.0;
      points.x[i] = static_cast<float>(seen * std::cos(elevation) * std::cos(azimuth));
      points.y[i] = static_cast<float>(seen * std::cos(elevation) * std::sin(azimuth));
      points.z[i] = static_cast<float>(seen * std::sin(elevation));
      points.intensity[i] =
          bright ? static_cast<float>(scan.intensityImage(row, column)) / 255.0f : 0.0f;
      points.ring[i] = geometry.rings[static_cast<std::size_t>(row)];
      const double share = static_cast<double>(std::min(column, geometry.columns)) /
                           static_cast<double>(geometry.columns);
      if (!points.time.empty()) points.time[i] = static_cast<float>(share * scan.sweepDuration);
    }
  }
}

}  // namespace

void readRotatingPoints(mrpt::obs::CObservation& observation, const std::string& place,
                        PosedScan& scan) {
  const auto& rotating = dynamic_cast<const CObservationRotatingScan&>(observation);
  scan.points.resize(0);
  if (rotating.rangeImage.size() == 0) return;
  const SensorModel& sensor = sensorOf(rotating, place);
  const ImageGeometry geometry =
      isMadeByMrpt(rotating) ? geometryOfMrpt(rotating) : geometryOf(rotating, sensor);
  fillPoints(rotating, geometry, scan.points);
  scan.sensorModel = sensor.name;
}

}  // namespace toss
