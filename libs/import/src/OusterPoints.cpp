// SPDX-License-Identifier: BSD-3-Clause
#include <toss/import/OusterPoints.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace toss {
namespace {

constexpr double kTurn = 2.0 * 3.14159265358979323846;
constexpr double kMetersPerMillimeter = 1e-3, kSecondsPerNanosecond = 1e-9;

/// Pixels of the packets by falling altitude.
std::vector<std::size_t> pixelsFromTop(const OusterMetadata& metadata) {
  std::vector<std::size_t> pixels(metadata.beamAltitudes.size());
  std::iota(pixels.begin(), pixels.end(), std::size_t{0});
  pixels.erase(std::remove_if(pixels.begin(), pixels.end(),
                              [&](std::size_t pixel) { return !metadata.beamActive[pixel]; }),
               pixels.end());
  std::stable_sort(pixels.begin(), pixels.end(), [&](std::size_t a, std::size_t b) {
    return metadata.beamAltitudes[a] > metadata.beamAltitudes[b];
  });
  return pixels;
}

/// Column in which a beam's azimuth in the points' frame is the smallest from 0 on.
std::size_t columnAtZero(const OusterMetadata& metadata, std::size_t pixel) {
  const Eigen::Matrix3d& turn = metadata.sensorFromLidar.linear();
  const double forward = std::atan2(turn(1, 0), turn(0, 0));
  const double columnsPerRadian = metadata.columnsPerFrame / kTurn;
  // Azimuth = turn - column / columnsPerRadian - offset + forward.
  const double column = std::floor((forward - metadata.beamAzimuths[pixel]) * columnsPerRadian);
  const double wrapped =
      column - metadata.columnsPerFrame * std::floor(column / metadata.columnsPerFrame);
  return static_cast<std::size_t>(wrapped);
}

/// "OS-1-64-U02" -> "OS1-64": as the known models are named.
std::string modelName(const OusterMetadata& metadata) {
  const std::string& line = metadata.productLine;
  if (line.empty()) return "Ouster-" + std::to_string(metadata.pixelsPerColumn);
  std::size_t end = line.find('-', line.find('-') + 1);
  if (end != std::string::npos) end = line.find('-', end + 1);
  std::string name = line.substr(0, end);
  if (name.size() > 3 && name.rfind("OS-", 0) == 0 && name[3] >= '0' && name[3] <= '9')
    name.erase(2, 1);
  return name;
}

struct RangeLimits {
  float nearest, farthest;
};

/// Data sheets [m]; the widest of all for other sensors.
RangeLimits limitsOf(const std::string& productLine) {
  const auto is = [&](const char* line) { return productLine.rfind(line, 0) == 0; };
  if (is("OS-0-")) return {0.3f, 100.0f};
  if (is("OS-1-")) return {0.3f, 200.0f};
  if (is("OS-2-")) return {0.8f, 400.0f};
  return {0.3f, 400.0f};
}

}  // namespace

SensorModel sensorModelOf(const OusterMetadata& metadata) {
  const RangeLimits limits = limitsOf(metadata.productLine);
  SensorModel model;
  model.name = modelName(metadata);
  for (const std::size_t pixel : pixelsFromTop(metadata))
    model.elevations.push_back(static_cast<float>(metadata.beamAltitudes[pixel]));
  model.columns = metadata.columnsPerFrame;
  model.minRange = limits.nearest;
  model.maxRange = limits.farthest;
  return model;
}

OusterPoints::OusterPoints(const OusterMetadata& metadata)
    : metadata_(metadata),
      model_(std::make_shared<const SensorModel>(sensorModelOf(metadata))),
      originDistance_(metadata.beamOriginUp == 0.0
                          ? metadata.beamOriginForward
                          : std::hypot(metadata.beamOriginForward, metadata.beamOriginUp)) {
  for (const std::size_t pixel : pixelsFromTop(metadata)) {
    const double altitude = metadata.beamAltitudes[pixel], azimuth = metadata.beamAzimuths[pixel];
    beams_.push_back({pixel, columnAtZero(metadata, pixel), std::cos(altitude), std::sin(altitude),
                      std::cos(azimuth), std::sin(azimuth)});
  }
  for (int column = 0; column < metadata.columnsPerFrame; ++column) {
    // The encoder turns clockwise seen from above; angles count the other way round.
    const double angle = kTurn * (1.0 - static_cast<double>(column) / metadata.columnsPerFrame);
    cosEncoder_.push_back(std::cos(angle));
    sinEncoder_.push_back(std::sin(angle));
  }
}

std::uint64_t OusterPoints::timeOf(const OusterFrame& frame) {
  std::uint64_t first = 0;
  for (std::size_t column = 0; column < frame.timestamp.size(); ++column)
    if (frame.valid[column] && (first == 0 || frame.timestamp[column] < first))
      first = frame.timestamp[column];
  return first;
}

void OusterPoints::toScan(const OusterFrame& frame, PosedScan& scan) const {
  scan.points.resize(0);
  scan.robotFromSensor = Eigen::Isometry3d::Identity();
  scan.robotFromSensor.translation() = metadata_.sensorFromLidar.translation();
  scan.beams = model_;
  const std::uint64_t begin = timeOf(frame);
  for (std::size_t ring = 0; ring < beams_.size(); ++ring) addRing(frame, ring, begin, scan.points);
}

void OusterPoints::addRing(const OusterFrame& frame, std::size_t ring, std::uint64_t begin,
                           PointCloud& points) const {
  const Beam& beam = beams_[ring];
  const std::size_t columns = frame.timestamp.size();
  for (std::size_t i = 0; i < columns; ++i) {
    const std::size_t column = (beam.firstColumn + columns - i) % columns;
    if (!frame.valid[column]) continue;
    const std::size_t pixel = beam.pixel * columns + column;
    for (const OusterFrame::Returns& returns : frame.returns) {
      if (returns.range.empty() || returns.range[pixel] == 0) continue;
      const Eigen::Vector3f place =
          position(beam, column, kMetersPerMillimeter * returns.range[pixel]);
      points.x.push_back(place.x());
      points.y.push_back(place.y());
      points.z.push_back(place.z());
      points.intensity.push_back(static_cast<float>(
          std::min(1.0, returns.reflectivity[pixel] / metadata_.fullReflectivity)));
      points.ring.push_back(static_cast<std::uint16_t>(ring));
      points.time.push_back(static_cast<float>(
          kSecondsPerNanosecond * static_cast<double>(frame.timestamp[column] - begin)));
    }
  }
}

Eigen::Vector3f OusterPoints::position(const Beam& beam, std::size_t column, double range) const {
  const double cosEncoder = cosEncoder_[column], sinEncoder = sinEncoder_[column];
  // Azimuth offsets count clockwise.
  const double x = cosEncoder * beam.cosAzimuth + sinEncoder * beam.sinAzimuth;
  const double y = sinEncoder * beam.cosAzimuth - cosEncoder * beam.sinAzimuth;
  const double beyond = range - originDistance_;
  const double level = beyond * beam.cosAltitude;
  const Eigen::Vector3d inLidar(level * x + metadata_.beamOriginForward * cosEncoder,
                                level * y + metadata_.beamOriginForward * sinEncoder,
                                beyond * beam.sinAltitude + metadata_.beamOriginUp);
  return (metadata_.sensorFromLidar.linear() * inLidar).cast<float>();
}

}  // namespace toss
