// SPDX-License-Identifier: BSD-3-Clause
#include "LineDrawing.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "TextDrawing.h"

namespace toss {
namespace {

constexpr int kFractionBits = 4;

std::optional<cv::Point> toFixedPoint(const Camera& camera, const Eigen::Vector3d& vertex) {
  // OpenCV counts from the middle of the first pixel, and takes 16-bit pixel coordinates safely.
  constexpr double kLimit = 30000.0;
  const auto place = camera.project(vertex);
  if (!place || std::abs(place->u) > kLimit || std::abs(place->v) > kLimit) return std::nullopt;
  const auto fixed = [](double value) {
    return static_cast<int>(std::lround((value - 0.5) * (1 << kFractionBits)));
  };
  return cv::Point(fixed(place->u), fixed(place->v));
}

double lineUnit(const cv::Mat& picture) {
  return std::max(0.5, picture.rows / 1080.0);
}

bool goesSomewhere(const TrackPath& path) {
  constexpr std::size_t kFewestBoxes = 5;
  constexpr double kLeastDistance = 1.5;
  return path.boxes.size() >= kFewestBoxes &&
         std::any_of(path.boxes.begin(), path.boxes.end(), [&](const Box& box) {
           return (box.center - path.boxes.front().center).norm() > kLeastDistance;
         });
}

}  // namespace

std::array<std::pair<Eigen::Vector3d, Eigen::Vector3d>, 12> edgesOf(const Box& box) {
  const double c = std::cos(box.yaw), s = std::sin(box.yaw);
  const auto corner = [&](unsigned bits) -> Eigen::Vector3d {
    const double x = (bits & 1u ? 0.5 : -0.5) * box.length;
    const double y = (bits & 2u ? 0.5 : -0.5) * box.width;
    const double z = (bits & 4u ? 0.5 : -0.5) * box.height;
    return box.center + Eigen::Vector3d(c * x - s * y, s * x + c * y, z);
  };
  std::array<std::pair<Eigen::Vector3d, Eigen::Vector3d>, 12> edges;
  std::size_t count = 0;
  for (unsigned from = 0; from < 8; ++from)
    for (unsigned axis = 1; axis <= 4; axis *= 2)
      if ((from & axis) == 0) edges[count++] = {corner(from), corner(from | axis)};
  return edges;
}

std::vector<Box> shownBoxes(const TrackPath& path) {
  std::vector<Box> shown;
  for (const Box& box : path.boxes) {
    const double step = std::max(8.0, 3.0 * std::max(box.length, box.width));
    if (shown.empty() || (box.center - shown.back().center).norm() >= step) shown.push_back(box);
  }
  if (!path.boxes.empty() && shown.back().center != path.boxes.back().center)
    shown.push_back(path.boxes.back());
  return shown;
}

void drawPolyline(cv::Mat& picture, const Camera& camera,
                  const std::vector<Eigen::Vector3d>& vertices, const Color& color, double width) {
  const int thickness = std::max(1, static_cast<int>(std::lround(width * lineUnit(picture))));
  for (std::size_t i = 1; i < vertices.size(); ++i) {
    const auto from = toFixedPoint(camera, vertices[i - 1]), to = toFixedPoint(camera, vertices[i]);
    if (from && to)
      cv::line(picture, *from, *to, toScalar(color), thickness, cv::LINE_AA, kFractionBits);
  }
}

void drawTrack(cv::Mat& picture, const Camera& camera, const TrackPath& path) {
  if (!goesSomewhere(path)) return;
  const Color color = trackColor(path.track);
  std::vector<Eigen::Vector3d> centers;
  for (const Box& box : path.boxes) centers.push_back(box.center);
  drawPolyline(picture, camera, centers, color, 1.0);
  for (const auto& [from, to] : edgesOf(path.boxes.back()))
    drawPolyline(picture, camera, {from, to}, color, 1.0);
}

}  // namespace toss
