// SPDX-License-Identifier: BSD-3-Clause
#include "Motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace toss::simulation {

using Eigen::Vector2d;

Path::Path(const std::vector<Vector2d>& waypoints, double turnIn) {
  append(waypoints.front());
  for (std::size_t i = 1; i + 1 < waypoints.size(); ++i) {
    const Vector2d& corner = waypoints[i];
    const Vector2d back = waypoints[i - 1] - corner, ahead = waypoints[i + 1] - corner;
    const double reach = std::min({turnIn, 0.499 * back.norm(), 0.499 * ahead.norm()});
    const Vector2d from = corner + reach * back.normalized();
    const Vector2d to = corner + reach * ahead.normalized();
    constexpr int kSteps = 16;
    for (int step = 0; step <= kSteps; ++step) {
      const double t = static_cast<double>(step) / kSteps;
      append((1 - t) * (1 - t) * from + 2 * t * (1 - t) * corner + t * t * to);
    }
  }
  append(waypoints.back());
}

void Path::append(const Vector2d& point) {
  const double step = points_.empty() ? 0.0 : (point - points_.back()).norm();
  if (!points_.empty() && step < 1e-6) return;
  distances_.push_back(points_.empty() ? 0.0 : distances_.back() + step);
  points_.push_back(point);
}

Vector2d Path::position(double distance) const {
  const auto after = std::upper_bound(distances_.begin() + 1, distances_.end() - 1, distance);
  const auto i = static_cast<std::size_t>(after - distances_.begin());
  const double share = (distance - distances_[i - 1]) / (distances_[i] - distances_[i - 1]);
  return points_[i - 1] + share * (points_[i] - points_[i - 1]);
}

double Path::heading(double distance) const {
  const Vector2d along = position(distance + 0.5) - position(distance - 0.5);
  return std::atan2(along.y(), along.x());
}

Path Path::shifted(double left) const {
  Path result;
  for (double distance : distances_) {
    const double heading = this->heading(distance);
    result.append(position(distance) + left * Vector2d(-std::sin(heading), std::cos(heading)));
  }
  return result;
}

SpeedProfile::SpeedProfile(std::vector<Knot> knots) : knots_(std::move(knots)), integrals_{0.0} {
  for (std::size_t i = 1; i < knots_.size(); ++i) {
    const double duration = knots_[i].time - knots_[i - 1].time;
    integrals_.push_back(integrals_.back() +
                         0.5 * duration * (knots_[i].speed + knots_[i - 1].speed));
  }
}

double SpeedProfile::speed(double time) const {
  if (time <= knots_.front().time) return knots_.front().speed;
  for (std::size_t i = 1; i < knots_.size(); ++i) {
    if (time > knots_[i].time) continue;
    const double share = (time - knots_[i - 1].time) / (knots_[i].time - knots_[i - 1].time);
    return knots_[i - 1].speed + share * (knots_[i].speed - knots_[i - 1].speed);
  }
  return knots_.back().speed;
}

double SpeedProfile::integral(double time) const {
  if (time <= knots_.front().time) return (time - knots_.front().time) * knots_.front().speed;
  std::size_t i = 0;
  while (i + 1 < knots_.size() && knots_[i + 1].time < time) ++i;
  return integrals_[i] + 0.5 * (time - knots_[i].time) * (knots_[i].speed + speed(time));
}

}  // namespace toss::simulation
