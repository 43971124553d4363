// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <toss/render/RenderUnavailable.h>

#include <array>
#include <cmath>
#include <functional>
#include <opencv2/imgcodecs.hpp>
#include <optional>
#include <vector>

#include "InputFixtures.h"
#include "OffscreenRenderer.h"

namespace toss::test {

/// Runs `draw`; where the machine can not draw off-screen, skips the test and says why.
#define TOSS_DRAW_OR_SKIP(draw)                                          \
  try {                                                                  \
    draw;                                                                \
  } catch (const RenderUnavailable& unavailable) {                       \
    GTEST_SKIP() << "nothing can be drawn here: " << unavailable.what(); \
  }

inline Color colorAt(const cv::Mat& picture, double u, double v) {
  const auto bgr =
      picture.at<cv::Vec3b>(static_cast<int>(std::floor(v)), static_cast<int>(std::floor(u)));
  return {bgr[2], bgr[1], bgr[0]};
}

inline bool isNear(const Color& a, const Color& b, int tolerance) {
  return std::abs(a.red - b.red) <= tolerance && std::abs(a.green - b.green) <= tolerance &&
         std::abs(a.blue - b.blue) <= tolerance;
}

/// Pixels of a picture that fulfil a condition.
struct Blob {
  int left = 1 << 30, right = -1, top = 1 << 30, bottom = -1;
  std::size_t pixels = 0;
  double u = 0.0, v = 0.0;  ///< Middle [px].
};

inline Blob findBlob(const cv::Mat& picture, const std::function<bool(const Color&)>& belongs) {
  Blob blob;
  for (int row = 0; row < picture.rows; ++row)
    for (int column = 0; column < picture.cols; ++column) {
      if (!belongs(colorAt(picture, column, row))) continue;
      blob.left = std::min(blob.left, column);
      blob.right = std::max(blob.right, column);
      blob.top = std::min(blob.top, row);
      blob.bottom = std::max(blob.bottom, row);
      blob.u += column + 0.5;
      blob.v += row + 0.5;
      ++blob.pixels;
    }
  if (blob.pixels > 0) blob.u /= static_cast<double>(blob.pixels);
  if (blob.pixels > 0) blob.v /= static_cast<double>(blob.pixels);
  return blob;
}

/// A flat rectangle of points, `step` [m] apart.
inline std::vector<MapPoint> rectangle(double left, double right, double low, double high, double z,
                                       double step) {
  std::vector<MapPoint> points;
  for (double x = left; x <= right; x += step)
    for (double y = low; y <= high; y += step)
      points.push_back({static_cast<float>(x), static_cast<float>(y), static_cast<float>(z), 0.5f});
  return points;
}

}  // namespace toss::test
