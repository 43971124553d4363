// SPDX-License-Identifier: BSD-3-Clause
#include <toss/render/Camera.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace toss {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kDegree = kPi / 180.0;

using Outline = std::vector<Eigen::Vector3d>;

/// The rectangle in which the outline is seen [px]; nothing where a part is behind the camera.
std::optional<PictureFrame> seenIn(const Camera& camera, const Outline& outline) {
  constexpr double kFar = std::numeric_limits<double>::max();
  PictureFrame seen{kFar, kFar, -kFar, -kFar};
  for (const Eigen::Vector3d& point : outline) {
    const auto place = camera.project(point);
    if (!place) return std::nullopt;
    seen.left = std::min(seen.left, place->u);
    seen.right = std::max(seen.right, place->u);
    seen.top = std::min(seen.top, place->v);
    seen.bottom = std::max(seen.bottom, place->v);
  }
  return seen;
}

bool isInside(const PictureFrame& inner, const PictureFrame& outer) {
  return inner.left >= outer.left && inner.right <= outer.right && inner.top >= outer.top &&
         inner.bottom <= outer.bottom;
}

/// Moves the target so that the middles of both rectangles agree.
void centerOn(Camera& camera, const PictureFrame& seen, const PictureFrame& frame) {
  const double scale = camera.pixelsPerMetre(camera.distance);
  const double toRight = 0.5 * (seen.left + seen.right - frame.left - frame.right);
  const double down = 0.5 * (seen.top + seen.bottom - frame.top - frame.bottom);
  camera.target += camera.right() * (toRight / scale) - camera.up() * (down / scale);
}

/// Perspective makes size and position depend on each other: solved by repetition, and the last
/// step only ever moves away.
void fit(Camera& camera, const Outline& outline, const PictureFrame& frame) {
  for (int step = 0; step < 40; ++step) {
    const auto seen = seenIn(camera, outline);
    if (!seen) {
      camera.distance *= 2.0;
      continue;
    }
    centerOn(camera, *seen, frame);
    const double ratio = std::max((seen->right - seen->left) / (frame.right - frame.left),
                                  (seen->bottom - seen->top) / (frame.bottom - frame.top));
    camera.distance *= std::clamp(ratio, 0.5, 2.0);
  }
  for (int step = 0; step < 200; ++step) {
    const auto seen = seenIn(camera, outline);
    if (seen && isInside(*seen, frame)) return;
    camera.distance *= 1.002;
    if (seen) centerOn(camera, *seen, frame);
  }
}

Extent withLeastSize(Extent extent) {
  const Eigen::Vector3d center = extent.center();
  const Eigen::Vector3d half = (0.5 * extent.size()).cwiseMax(0.5);
  return {center - half, center + half};
}

}  // namespace

Eigen::Vector3d Camera::forward() const {
  return -Eigen::Vector3d(std::cos(azimuth) * std::cos(elevation),
                          std::sin(azimuth) * std::cos(elevation), std::sin(elevation));
}

Eigen::Vector3d Camera::right() const {
  return {-std::sin(azimuth), std::cos(azimuth), 0.0};
}

Eigen::Vector3d Camera::up() const {
  return right().cross(forward());
}

Eigen::Vector3d Camera::position() const {
  return target - distance * forward();
}

double Camera::pixelsPerMetre(double depth) const {
  if (!perspective) return height / (0.5 * distance);
  return 0.5 * height / (std::tan(0.5 * kFieldOfView) * depth);
}

std::optional<PicturePoint> Camera::project(const Eigen::Vector3d& point) const {
  const Eigen::Vector3d fromCamera = point - position();
  const double depth = fromCamera.dot(forward());
  if (perspective && depth < 1e-6 * distance) return std::nullopt;
  const double scale = pixelsPerMetre(depth);
  return PicturePoint{0.5 * width + scale * fromCamera.dot(right()),
                      0.5 * height - scale * fromCamera.dot(up()), depth};
}

Camera frameView(View view, const ViewSubject& subject, int width, int height,
                 const PictureFrame& frame) {
  Extent shown = withLeastSize(subject.extent);
  Outline outline = subject.outline;
  Camera camera;
  camera.width = width;
  camera.height = height;
  camera.perspective = view != View::Top;
  if (view == View::Top) {
    camera.azimuth = -0.5 * kPi;
    camera.elevation = 0.5 * kPi;
  } else if (view == View::Corner) {
    camera.azimuth = -0.75 * kPi;
    camera.elevation = 40.0 * kDegree;
  } else {
    camera.azimuth = subject.heading + kPi;
    camera.elevation = 28.0 * kDegree;
    const Eigen::Vector3d half(0.25 * shown.size().x(), 0.25 * shown.size().y(), 0.0);
    shown = withLeastSize({subject.focus - half, subject.focus + half});
    outline.clear();
  }
  // The corners of the extent keep the scale finite where the map is a single point.
  if (outline.empty() || shown.size().maxCoeff() <= 1.0)
    for (const Eigen::Vector3d& corner : shown.corners()) outline.push_back(corner);
  camera.target = shown.center();
  camera.distance = 4.0 * shown.size().norm();
  fit(camera, outline, frame);
  return camera;
}

}  // namespace toss
