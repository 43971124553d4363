// SPDX-License-Identifier: BSD-3-Clause
#include "TextDrawing.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace toss {
namespace {

constexpr int kFont = cv::FONT_HERSHEY_SIMPLEX;
// Capital letters of this font are 22 units high.
constexpr double kUnitsPerHeight = 22.0;

double fontScale(const TextStyle& style) {
  return style.height / kUnitsPerHeight;
}

int strokeWidth(const TextStyle& style) {
  return std::max(1, static_cast<int>(std::lround(style.height * (style.bold ? 0.15 : 0.1))));
}

/// Puts `color` over the canvas as far as the mask (0..255) says.
void blend(cv::Mat& canvas, const cv::Mat& mask, cv::Point corner, const Color& color) {
  const cv::Scalar bgr = toScalar(color);
  for (int row = 0; row < mask.rows; ++row)
    for (int column = 0; column < mask.cols; ++column) {
      const cv::Point place(corner.x + column, corner.y + row);
      if (place.x < 0 || place.y < 0 || place.x >= canvas.cols || place.y >= canvas.rows) continue;
      const double share = mask.at<std::uint8_t>(row, column) / 255.0;
      auto& pixel = canvas.at<cv::Vec3b>(place);
      for (int channel = 0; channel < 3; ++channel)
        pixel[channel] = cv::saturate_cast<std::uint8_t>(pixel[channel] +
                                                         share * (bgr[channel] - pixel[channel]));
    }
}

std::string shortened(const std::string& text, std::size_t kept) {
  const std::size_t begin = (kept + 1) / 2, end = kept / 2;
  return text.substr(0, begin) + "..." + text.substr(text.size() - end);
}

}  // namespace

std::string drawableText(const std::string& text) {
  std::string result;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte & 0xC0u) == 0x80u) continue;
    result += byte < 0x20 || byte > 0x7E ? '?' : c;
  }
  return result;
}

double textWidth(const std::string& text, const TextStyle& style) {
  // Measured large, where the library's rounding does not matter.
  constexpr double kLarge = 16.0;
  int baseline = 0;
  return cv::getTextSize(text, kFont, kLarge * fontScale(style), 1, &baseline).width / kLarge +
         style.height * (style.bold ? 0.15 : 0.1);
}

std::string fitText(const std::string& text, double width, TextStyle& style) {
  const std::string drawable = drawableText(text);
  const double wanted = textWidth(drawable, style);
  if (wanted <= width) return drawable;
  style.height *= std::max(2.0 / 3.0, 0.98 * width / wanted);
  if (textWidth(drawable, style) <= width) return drawable;
  std::size_t kept = drawable.size();
  while (kept > 0 && textWidth(shortened(drawable, kept), style) > width) --kept;
  return shortened(drawable, kept);
}

double drawText(cv::Mat& canvas, const std::string& text, double x, double y,
                const TextStyle& style) {
  const double width = textWidth(text, style);
  if (text.empty()) return x;
  // Letters are drawn enlarged into a mask and averaged, which makes them smoother than OpenCV
  // does.
  constexpr int kEnlarged = 4;
  const int margin = static_cast<int>(style.height);
  const cv::Rect area(static_cast<int>(std::floor(x)) - margin,
                      static_cast<int>(std::floor(y - style.height)) - margin,
                      static_cast<int>(width) + 2 * margin + 2,
                      static_cast<int>(2.0 * style.height) + 2 * margin);
  const TextStyle enlarged{style.height * kEnlarged, style.color, style.bold};
  cv::Mat large(area.size() * kEnlarged, CV_8UC1, cv::Scalar(0)), mask;
  const auto place = [](double value) { return static_cast<int>(std::lround(kEnlarged * value)); };
  cv::putText(large, text, {place(x - area.x), place(y + 0.5 * style.height - area.y)}, kFont,
              fontScale(enlarged), cv::Scalar(255), strokeWidth(enlarged), cv::LINE_AA);
  cv::resize(large, mask, area.size(), 0, 0, cv::INTER_AREA);
  blend(canvas, mask, area.tl(), style.color);
  return x + width;
}

}  // namespace toss
