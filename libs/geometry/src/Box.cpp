// SPDX-License-Identifier: BSD-3-Clause
#include <toss/geometry/Box.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

namespace toss {
namespace {

/// Convex polygon. A rectangle cut by four half-planes has at most 8 corners; rounding may bend it
/// a little out of convexity, and then each cut adds at most half of the corners.
struct Polygon {
  std::array<Eigen::Vector2d, 20> corners;
  std::size_t count = 0;

  void add(const Eigen::Vector2d& corner) { corners[count++] = corner; }
};

/// Keeps the part of `polygon` where sign * coordinate[axis] <= limit (Sutherland-Hodgman).
Polygon cut(const Polygon& polygon, int axis, double sign, double limit) {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.count; ++i) {
    const Eigen::Vector2d& from = polygon.corners[i];
    const Eigen::Vector2d& to = polygon.corners[(i + 1) % polygon.count];
    const double fromOutside = sign * from[axis] - limit, toOutside = sign * to[axis] - limit;
    if (fromOutside <= 0.0) kept.add(from);
    // Only strictly opposite sides give a crossing, so the denominator is never zero.
    if ((fromOutside < 0.0 && toOutside > 0.0) || (fromOutside > 0.0 && toOutside < 0.0)) {
      kept.add(from + fromOutside / (fromOutside - toOutside) * (to - from));
    }
  }
  return kept;
}

double area(const Polygon& polygon) {
  double twice = 0.0;
  for (std::size_t i = 0; i < polygon.count; ++i) {
    const Eigen::Vector2d& from = polygon.corners[i];
    const Eigen::Vector2d& to = polygon.corners[(i + 1) % polygon.count];
    twice += from.x() * to.y() - to.x() * from.y();
  }
  return 0.5 * twice;
}

double overlap(double distance, double firstExtent, double secondExtent) {
  const double reach = 0.5 * (firstExtent + secondExtent) - std::abs(distance);
  return std::max(0.0, std::min({reach, firstExtent, secondExtent}));
}

/// Footprint of `box` in the frame of `frame`: coordinates stay small however far from the origin.
Polygon footprintIn(const Box& box, const Box& frame) {
  const Eigen::Vector2d apart = (box.center - frame.center).head<2>();
  const Eigen::Rotation2Dd frameFromMap(-frame.yaw), frameFromBox(box.yaw - frame.yaw);
  const Eigen::Vector2d center = frameFromMap * apart;
  const Eigen::Vector2d alongLength = frameFromBox * Eigen::Vector2d(0.5 * box.length, 0.0);
  const Eigen::Vector2d alongWidth = frameFromBox * Eigen::Vector2d(0.0, 0.5 * box.width);
  Polygon footprint;
  footprint.add(center - alongLength - alongWidth);
  footprint.add(center + alongLength - alongWidth);
  footprint.add(center + alongLength + alongWidth);
  footprint.add(center - alongLength + alongWidth);
  return footprint;
}

}  // namespace

double footprintIntersection(const Box& a, const Box& b) {
  const Eigen::Vector2d apart = (b.center - a.center).head<2>();
  if (a.yaw == 0.0 && b.yaw == 0.0) {
    return overlap(apart.x(), a.length, b.length) * overlap(apart.y(), a.width, b.width);
  }
  const double reach = 0.5 * (std::hypot(a.length, a.width) + std::hypot(b.length, b.width));
  if (!(apart.squaredNorm() <= reach * reach)) return 0.0;
  Polygon common = footprintIn(a, b);
  for (const double sign : {1.0, -1.0}) {
    common = cut(common, 0, sign, 0.5 * b.length);
    common = cut(common, 1, sign, 0.5 * b.width);
  }
  return std::clamp(area(common), 0.0, std::min(a.length * a.width, b.length * b.width));
}

double intersectionOverUnion(const Box& a, const Box& b) {
  const double high = overlap(b.center.z() - a.center.z(), a.height, b.height);
  if (!(high > 0.0)) return 0.0;
  const double both = high * footprintIntersection(a, b);
  const double either = a.volume() + b.volume() - both;
  return either > 0.0 ? std::clamp(both / either, 0.0, 1.0) : 0.0;
}

bool contains(const Box& box, const Eigen::Vector3d& point, double margin) {
  const Eigen::Vector3d apart = point - box.center;
  const Eigen::Vector2d flat = Eigen::Rotation2Dd(-box.yaw) * apart.head<2>();
  return std::abs(flat.x()) <= 0.5 * box.length + margin &&
         std::abs(flat.y()) <= 0.5 * box.width + margin &&
         std::abs(apart.z()) <= 0.5 * box.height + margin;
}

}  // namespace toss
