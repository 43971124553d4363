// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/Box.h>
#include <toss/geometry/PosedScan.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace toss {

/// What is to be simulated.
struct SimulationOptions {
  /// Name of the scene (see knownScenes()).
  std::string scene = "street";
  /// Number of scans at 10 Hz, 1 to 100000; 0 = the scene's own number.
  int frames = 0;
  /// Seed of everything random: layout, noise, drop-out. The same seed gives the same bytes,
  /// whatever the number of threads.
  std::uint64_t seed = 1;
  /// Name of a sensor of knownSensors(); "" = the scene's own.
  std::string sensor;
  /// Errors of the poses: 0 = exact, 1 = as a good LiDAR odometry makes them (jitter of 1 cm and
  /// 0.03 degrees, drift of 1 cm and 0.02 degrees per root of a metre), larger = worse; 0 to 100.
  double poseNoise = 0.0;
  /// Whether the robot's motion within the sweep is taken out of the points, as in KITTI odometry
  /// and SemanticKITTI. Objects that move stay smeared either way.
  bool compensated = true;
  /// Whether the sensor errs: range noise, drop-out, beams that pass leaves and panes or straddle
  /// edges, mirror returns. Off for closed-form tests.
  bool sensorNoise = true;
  /// Pose of the sensor on the robot, which is where the scene's only sensor would be (robot <-
  /// sensor) [m], and time of the first scan [s]: for robots with several LiDARs, a simulator each
  /// with the same scene, seed and number of scans.
  Eigen::Isometry3d robotFromSensor = Eigen::Isometry3d::Identity();
  double startTime = 0.0;
  /// Threads that cast rays; 0 = all cores.
  int threads = 0;
};

/// An object of the world as it is at the time stamp of a scan.
struct GroundTruthBox {
  /// Instance id, the high 16 bits of the labels; the same in all scans.
  std::uint16_t track = 0;
  /// Class of the labels (SemanticKITTI), e.g. 10 parked car, 252 moving car.
  std::uint16_t label = 0;
  /// Whether the object moves at any time in the log.
  bool moving = false;
  /// Upright box around the object in rest pose, map frame (exact, without pose noise).
  Box box;
  /// Velocity of the box [m/s], map frame.
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
  /// Returns of the scan that lie on the object.
  std::uint32_t points = 0;
};

/// One simulated scan with what is known about it.
struct SimulatedScan {
  /// As any input delivers it. Points lie ring after ring from the topmost beam, azimuth growing
  /// from 0 to 2 pi within a ring as in KITTI's files; only valid returns. `ring` and `time` are
  /// filled; mapFromSensor carries the pose noise.
  PosedScan scan;
  /// Low 16 bits: SemanticKITTI class; high 16: instance id, 0 for what is no object. Shape [n].
  /// An object that moves at any time in the log has its moving class (252 to 259) in every scan
  /// in which it is seen, also while it stands. Doors count as 259. Mirror returns are 1, outlier.
  std::vector<std::uint32_t> labels;
  /// Every object with at least one return in this scan, by ascending track.
  std::vector<GroundTruthBox> boxes;
  /// Pose of the sensor without pose noise.
  Eigen::Isometry3d trueMapFromSensor = Eigen::Isometry3d::Identity();
};

/// Casts the rays of a spinning LiDAR through a procedural world, scan by scan. Rolling shutter:
/// the sweep starts at the rear, runs clockwise and takes 0.1 s; the time stamp is its middle, when
/// the sensor looks ahead. The map frame has z up and the ground near the start at z = 0.
/// The bytes are the same for any number of threads and on every x86-64 processor, up to what the
/// last bits of the C library's functions can change; on other processors single returns at the
/// edges of things may differ.
class Simulator {
 public:
  /// Builds the world. Throws UserError for an unknown scene or sensor and values out of range.
  explicit Simulator(const SimulationOptions& options);
  ~Simulator();

  /// Makes the next scan into `result`, reusing its buffers; false after the last one.
  bool next(SimulatedScan& result);
  /// Number of scans in all.
  int frames() const;
  /// Name of the sensor in use.
  const std::string& sensorName() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace toss
