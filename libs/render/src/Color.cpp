// SPDX-License-Identifier: BSD-3-Clause
#include <toss/render/Color.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace toss {
namespace {

using Table = std::array<Color, 256>;

Table tableOf(cv::ColormapTypes map) {
  cv::Mat positions(1, 256, CV_8UC1), colors;
  for (int i = 0; i < 256; ++i) positions.at<std::uint8_t>(i) = static_cast<std::uint8_t>(i);
  cv::applyColorMap(positions, colors, map);
  Table table;
  for (int i = 0; i < 256; ++i) {
    const auto bgr = colors.at<cv::Vec3b>(i);
    table[static_cast<std::size_t>(i)] = {bgr[2], bgr[1], bgr[0]};
  }
  return table;
}

Color entryOf(const Table& table, double position) {
  return table[static_cast<std::size_t>(std::lround(255.0 * position))];
}

}  // namespace

Color rampColor(Ramp ramp, double position) {
  static const Table turbo = tableOf(cv::COLORMAP_TURBO);
  static const Table viridis = tableOf(cv::COLORMAP_VIRIDIS);
  const double t = std::isfinite(position) ? std::clamp(position, 0.0, 1.0) : 0.0;
  switch (ramp) {
    case Ramp::Turbo:
      return entryOf(turbo, 0.13 + 0.79 * t);
    case Ramp::Viridis:
      return entryOf(viridis, 0.12 + 0.88 * t);
    case Ramp::Gray:
      break;
  }
  const auto gray = static_cast<std::uint8_t>(std::lround(88.0 + 104.0 * t));
  return {gray, gray, static_cast<std::uint8_t>(gray + 12)};
}

Color trackColor(std::uint64_t track) {
  constexpr std::array<Color, 8> kColors = {{{255, 200, 40},
                                             {60, 200, 255},
                                             {120, 230, 90},
                                             {230, 120, 255},
                                             {255, 150, 60},
                                             {80, 240, 200},
                                             {150, 160, 255},
                                             {225, 235, 90}}};
  return kColors[track % kColors.size()];
}

}  // namespace toss
