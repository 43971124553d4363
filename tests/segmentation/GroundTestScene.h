// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/PosedScan.h>
#include <toss/geometry/SensorModel.h>

#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <vector>

namespace toss::test {

/// A scene of flat pieces and boxes with known ground, map frame [m], scanned by ray casting.
class GroundTestScene {
 public:
  enum Surface { Ground, Object, Nothing };

  /// Ground z = height + slopeX x + slopeY y where `within(x, y)` holds.
  void addGround(double height, double slopeX = 0.0, double slopeY = 0.0,
                 std::function<bool(double, double)> within = nullptr) {
    pieces_.push_back({height, slopeX, slopeY, std::move(within)});
  }
  void addBox(const Eigen::Vector3d& low, const Eigen::Vector3d& high, Surface kind) {
    boxes_.push_back({low, high, kind});
  }

  /// The scan, and what each of its returns lies on.
  struct Scan {
    PosedScan posed;
    std::vector<Surface> surface;
  };

  /// `noise`: standard deviation of the range [m].
  Scan scan(const SensorModel& sensor, const Eigen::Isometry3d& mapFromSensor, int columns = 720,
            double noise = 0.01) const {
    Scan result;
    result.posed.mapFromSensor = mapFromSensor;
    std::mt19937 random(1);
    std::normal_distribution<double> error(0.0, noise);
    for (std::size_t row = 0; row < sensor.elevations.size(); ++row) {
      const double elevation = static_cast<double>(sensor.elevations[row]);
      for (int column = 0; column < columns; ++column) {
        const double azimuth = 2.0 * M_PI * (column + 0.5) / columns;
        const Eigen::Vector3d ray(std::cos(elevation) * std::cos(azimuth),
                                  std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
        const Hit hit = cast(mapFromSensor.translation(), mapFromSensor.linear() * ray);
        if (hit.distance > static_cast<double>(sensor.maxRange)) continue;
        append(result, (hit.distance + error(random)) * ray, row, hit.surface);
      }
    }
    return result;
  }

  /// Adds one return, sensor frame [m], to a scan that has rings.
  static void append(Scan& scan, const Eigen::Vector3d& point, std::size_t ring, Surface surface) {
    PointCloud& points = scan.posed.points;
    points.x.push_back(static_cast<float>(point.x()));
    points.y.push_back(static_cast<float>(point.y()));
    points.z.push_back(static_cast<float>(point.z()));
    points.intensity.push_back(0.0f);
    points.ring.push_back(static_cast<std::uint16_t>(ring));
    scan.surface.push_back(surface);
  }

 private:
  struct Piece {
    double height, slopeX, slopeY;
    std::function<bool(double, double)> within;
  };
  struct SceneBox {
    Eigen::Vector3d low, high;
    Surface kind;
  };
  struct Hit {
    double distance = std::numeric_limits<double>::max();
    Surface surface = Nothing;
  };

  Hit cast(const Eigen::Vector3d& origin, const Eigen::Vector3d& ray) const {
    Hit nearest;
    for (const Piece& piece : pieces_) {
      const Eigen::Vector3d up(-piece.slopeX, -piece.slopeY, 1.0);
      const double distance = (piece.height - up.dot(origin)) / up.dot(ray);
      if (!(distance > 0.1) || distance >= nearest.distance) continue;
      const Eigen::Vector3d at = origin + distance * ray;
      if (!piece.within || piece.within(at.x(), at.y())) nearest = {distance, Ground};
    }
    for (const SceneBox& box : boxes_) {
      const Eigen::Array3d a = (box.low - origin).array() / ray.array();
      const Eigen::Array3d b = (box.high - origin).array() / ray.array();
      const double enter = a.min(b).maxCoeff(), leave = a.max(b).minCoeff();
      if (enter > 0.1 && enter <= leave && enter < nearest.distance) nearest = {enter, box.kind};
    }
    return nearest;
  }

  std::vector<Piece> pieces_;
  std::vector<SceneBox> boxes_;
};

/// Pose of a sensor at a place [m, map], turned by yaw, pitch (nose down positive), roll [rad].
inline Eigen::Isometry3d sensorAt(const Eigen::Vector3d& place, double yaw = 0.0,
                                  double pitch = 0.0, double roll = 0.0) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = place;
  pose.linear() = (Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) *
                   Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()) *
                   Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitX()))
                      .toRotationMatrix();
  return pose;
}

}  // namespace toss::test
