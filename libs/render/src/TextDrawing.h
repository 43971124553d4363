// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/render/Color.h>

#include <opencv2/core/mat.hpp>
#include <string>

namespace toss {

/// A line of text as it is drawn.
struct TextStyle {
  /// Height of a capital letter [px].
  double height = 20.0;
  Color color;
  bool bold = false;
};

inline cv::Scalar toScalar(const Color& color) {
  return cv::Scalar(color.blue, color.green, color.red);
}

/// The text with everything that OpenCV's fonts lack replaced by '?'.
std::string drawableText(const std::string& text);

/// Width of the text [px].
double textWidth(const std::string& text, const TextStyle& style);

/// `text` as it is if it fits into `width` [px]; else in smaller letters, down to two thirds of
/// style.height, which is changed; else with "..." in place of its middle.
std::string fitText(const std::string& text, double width, TextStyle& style);

/// Draws with the left end at x and the letters' vertical middle at y [px]; returns the right end.
double drawText(cv::Mat& canvas, const std::string& text, double x, double y,
                const TextStyle& style);

}  // namespace toss
