// SPDX-License-Identifier: BSD-3-Clause
#include <toss/tracking/FaceMotion.h>

#include <algorithm>
#include <cmath>

namespace toss {
namespace {

/// Straight line y(t) fitted by least squares.
class LineFit {
 public:
  void add(double t, double y) {
    ++count_;
    t_ += t, y_ += y, tt_ += t * t, ty_ += t * y, yy_ += y * y;
  }

  double slope() const { return covariance() / spread(); }

  /// Unbiased standard deviation about the line.
  double scatter() const {
    const double squares = yy_ - y_ * y_ / count_ - slope() * covariance();
    return std::sqrt(std::max(0.0, squares) / (count_ - 2.0));
  }

 private:
  double covariance() const { return ty_ - t_ * y_ / count_; }
  double spread() const { return tt_ - t_ * t_ / count_; }

  double count_ = 0.0, t_ = 0.0, y_ = 0.0, tt_ = 0.0, ty_ = 0.0, yy_ = 0.0;
};

/// Times and places relative to the first box: sums of squares of map coordinates would cancel.
Eigen::Vector2d placeOf(const TimedBox& timed, const TimedBox& origin) {
  return (timed.box.center - origin.box.center).head<2>();
}

Eigen::Vector2d velocityOf(const std::vector<TimedBox>& boxes) {
  LineFit x, y;
  for (const TimedBox& timed : boxes) {
    const Eigen::Vector2d place = placeOf(timed, boxes.front());
    x.add(timed.time - boxes.front().time, place.x());
    y.add(timed.time - boxes.front().time, place.y());
  }
  return {x.slope(), y.slope()};
}

}  // namespace

double reachAlong(const Box& box, const Eigen::Vector2d& direction) {
  const double cosine = std::cos(box.yaw), sine = std::sin(box.yaw);
  return 0.5 * (box.length * std::abs(cosine * direction.x() + sine * direction.y()) +
                box.width * std::abs(cosine * direction.y() - sine * direction.x()));
}

FaceMotion fitFaceMotion(const std::vector<TimedBox>& boxes) {
  if (boxes.size() < 3) return {};
  const Eigen::Vector2d velocity = velocityOf(boxes);
  const double speed = velocity.norm();
  if (!(speed > 0.0)) return {};
  const Eigen::Vector2d direction = velocity / speed;
  LineFit front, rear;
  for (const TimedBox& timed : boxes) {
    const double time = timed.time - boxes.front().time;
    const double along = direction.dot(placeOf(timed, boxes.front()));
    const double reach = reachAlong(timed.box, direction);
    front.add(time, along + reach);
    rear.add(time, along - reach);
  }
  const double duration = boxes.back().time - boxes.front().time;
  const double frontMotion = front.slope() * duration, rearMotion = rear.slope() * duration;
  return {speed * duration, std::max(frontMotion, rearMotion), std::min(frontMotion, rearMotion),
          std::max(front.scatter(), rear.scatter())};
}

}  // namespace toss
