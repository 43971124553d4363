// SPDX-License-Identifier: BSD-3-Clause
#include "EyeDome.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace toss {
namespace {

constexpr float kNothing = 1e9f;
// Chosen by eye on street maps.
constexpr double kGain = 60.0;
constexpr float kDarkest = 0.25f;

/// Depths on a scale where equal steps look alike: logarithms with perspective, else depths over
/// the distance from which a camera with perspective would show as many metres.
cv::Mat toEvenScale(const DepthImage& depth) {
  const double near = depth.near, far = depth.far;
  // Half of distance metres are seen from top to bottom; see Camera.
  const double comparable = 0.25 * depth.distance / std::tan(15.0 / 180.0 * 3.14159265358979);
  cv::Mat result(depth.values.size(), CV_32FC1);
  for (int row = 0; row < result.rows; ++row) {
    const float* in = depth.values.ptr<float>(row);
    float* out = result.ptr<float>(row);
    for (int column = 0; column < result.cols; ++column) {
      const double value = in[column];
      if (!(value > 0.0)) {
        out[column] = kNothing;
      } else if (depth.perspective) {
        out[column] = std::log2(static_cast<float>(value));
      } else {
        const double normalised = (far + near - 2.0 * near * far / value) / (far - near);
        out[column] = static_cast<float>((near + 0.5 * (normalised + 1.0) * (far - near)) /
                                         comparable / std::log(2.0));
      }
    }
  }
  return result;
}

}  // namespace

void shadeByDepth(cv::Mat& picture, const DepthImage& depth, double strength, int radius) {
  const cv::Mat even = toEvenScale(depth);
  const int diagonal = std::max(1, static_cast<int>(std::lround(0.7071 * radius)));
  const std::array<cv::Point, 8> neighbours = {{{radius, 0},
                                                {diagonal, diagonal},
                                                {0, radius},
                                                {-diagonal, diagonal},
                                                {-radius, 0},
                                                {-diagonal, -diagonal},
                                                {0, -radius},
                                                {diagonal, -diagonal}}};
  const auto gain = static_cast<float>(strength * kGain / 8.0);
  for (int row = 0; row < picture.rows; ++row) {
    auto* pixels = picture.ptr<cv::Vec3b>(row);
    for (int column = 0; column < picture.cols; ++column) {
      const float own = even.at<float>(row, column);
      if (own == kNothing) continue;
      float inFront = 0.0f;
      for (const cv::Point& step : neighbours) {
        const int r = std::clamp(row + step.y, 0, picture.rows - 1);
        const int c = std::clamp(column + step.x, 0, picture.cols - 1);
        inFront += std::max(0.0f, own - even.at<float>(r, c));
      }
      const float light = std::max(kDarkest, std::exp(-gain * inFront));
      for (int channel = 0; channel < 3; ++channel)
        pixels[column][channel] =
            static_cast<std::uint8_t>(light * static_cast<float>(pixels[column][channel]) + 0.5f);
    }
  }
}

}  // namespace toss
