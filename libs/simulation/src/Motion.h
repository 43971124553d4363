// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

namespace toss::simulation {

/// Way over the ground: straight legs between waypoints with rounded corners, by arc length; beyond
/// both ends it goes on straight.
class Path {
 public:
  /// `waypoints`: at least two, distinct [m]. `turnIn`: how far before and after a corner the curve
  /// reaches [m], less where legs are short.
  explicit Path(const std::vector<Eigen::Vector2d>& waypoints, double turnIn = 6.0);

  Eigen::Vector2d position(double distance) const;
  /// Direction of travel [rad], averaged over 1 m.
  double heading(double distance) const;
  double length() const { return distances_.back(); }
  /// The same path `left` metres further to the left.
  Path shifted(double left) const;

 private:
  Path() = default;
  void append(const Eigen::Vector2d& point);

  std::vector<Eigen::Vector2d> points_;
  std::vector<double> distances_;
};

/// Speed over time: straight lines between knots, constant before the first and after the last.
class SpeedProfile {
 public:
  struct Knot {
    /// [s] and [m/s].
    double time, speed;
  };
  /// `knots`: at least one, by ascending time.
  explicit SpeedProfile(std::vector<Knot> knots);
  static SpeedProfile constant(double speed) { return SpeedProfile({{0.0, speed}}); }

  double speed(double time) const;
  /// Distance travelled since the time 0 [m].
  double distance(double time) const { return integral(time) - integral(0.0); }

 private:
  double integral(double time) const;

  std::vector<Knot> knots_;
  std::vector<double> integrals_;
};

/// Travel along a path: at time 0 at `start` [m of the path].
struct Motion {
  Path path;
  SpeedProfile speed;
  double start = 0.0;

  double distance(double time) const { return start + speed.distance(time); }
  Eigen::Vector2d position(double time) const { return path.position(distance(time)); }
  double heading(double time) const { return path.heading(distance(time)); }
};

}  // namespace toss::simulation
