// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/PosedScan.h>
#include <toss/import/OusterFrames.h>
#include <toss/import/OusterMetadata.h>

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace toss {

/// Turns frames of an Ouster sensor into points (Ouster's sensor user manual, "Lidar Range to
/// XYZ"): with range r, distance n between the LiDAR's origin and where the beams start, encoder
/// angle e, azimuth offset a (clockwise) and altitude b of the beam, in the LiDAR frame
///   x = (r - n) cos(e - a) cos b + n cos e,  y = (r - n) sin(e - a) cos b + n sin e,
///   z = (r - n) sin b.
/// The points' frame has the axes of the sensor's housing (x forward, z up) and the LiDAR's origin;
/// where that lies in the housing's frame is robotFromSensor: the "robot" is the housing.
class OusterPoints {
 public:
  explicit OusterPoints(const OusterMetadata& metadata);

  /// Sets points, robotFromSensor and beams of the scan, reusing its buffers; not time, pose,
  /// label. Pixels without a return give no point. Order: ring after ring from the top, azimuth
  /// growing inside a ring from 0 on, the second return of a pixel after the first. `intensity`:
  /// 0..1; `ring`: 0 = topmost; `time`: relative to timeOf(frame) [s].
  void toScan(const OusterFrame& frame, PosedScan& scan) const;

  /// Time of the first valid column of a frame [ns, sensor's clock]; 0 where there is none.
  static std::uint64_t timeOf(const OusterFrame& frame);

 private:
  /// A beam of the packets: its pixel, the column with the smallest azimuth from 0 on, and its
  /// direction.
  struct Beam {
    std::size_t pixel = 0, firstColumn = 0;
    double cosAltitude = 1.0, sinAltitude = 0.0, cosAzimuth = 1.0, sinAzimuth = 0.0;
  };

  void addRing(const OusterFrame& frame, std::size_t ring, std::uint64_t begin,
               PointCloud& points) const;
  Eigen::Vector3f position(const Beam& beam, std::size_t column, double range) const;

  OusterMetadata metadata_;
  std::shared_ptr<const SensorModel> model_;
  /// Topmost first.
  std::vector<Beam> beams_;
  /// Cosine and sine of the encoder's angle at each column, shape [columnsPerFrame].
  std::vector<double> cosEncoder_, sinEncoder_;
  /// Distance between the LiDAR's origin and where the beams start [m].
  double originDistance_;
};

/// The beams of a sensor as the range image needs them, named by the product line ("OS1-64").
SensorModel sensorModelOf(const OusterMetadata& metadata);

}  // namespace toss
