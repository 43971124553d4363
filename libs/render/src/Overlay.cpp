// SPDX-License-Identifier: BSD-3-Clause
#include "Overlay.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <opencv2/imgproc.hpp>

#include "TextDrawing.h"

namespace toss {
namespace {

/// Size of the design's unit [px]: everything is laid out for 1080 lines, narrow pictures excepted.
double unitOf(int width, int height) {
  return std::min(height / 1080.0, width / 1280.0);
}

int topStripHeight(double unit) {
  return static_cast<int>(std::lround(64.0 * unit));
}
int bottomStripHeight(double unit) {
  return static_cast<int>(std::lround(60.0 * unit));
}

std::string numberText(double value) {
  char text[32];
  // Steps of a hundredth up to ten, of a tenth up to a hundred: digits beyond these say nothing.
  const double step = std::abs(value) >= 100.0 ? 1.0 : std::abs(value) >= 10.0 ? 0.1 : 0.01;
  std::snprintf(text, sizeof text, "%.6g", std::round(value / step) * step);
  return std::string(text) == "-0" ? "0" : text;
}

/// A strip across the picture, filled with the panel's colour, with lengths in units.
class Strip {
 public:
  Strip(cv::Mat& picture, int top, int height, const Theme& theme, double unit)
      : canvas(picture.rowRange(top, top + height)), theme_(theme), unit_(unit) {
    canvas.setTo(toScalar(theme.panel));
  }

  /// The same strip with shorter lengths.
  Strip shrunk(double factor) const {
    Strip result = *this;
    result.unit_ *= factor;
    return result;
  }
  double px(double units) const { return units * unit_; }
  double middle() const { return 0.5 * canvas.rows; }
  TextStyle letters(double units, bool bold = false) const {
    return {px(units), bold ? theme_.text : theme_.faint, bold};
  }
  void rectangle(double left, double top, double right, double bottom, const Color& color) {
    const auto whole = [](double value) { return static_cast<int>(std::lround(value)); };
    cv::rectangle(canvas, {whole(left), whole(top)}, {whole(right) - 1, whole(bottom) - 1},
                  toScalar(color), cv::FILLED);
  }

  cv::Mat canvas;

 private:
  const Theme& theme_;
  double unit_;
};

void drawTitles(cv::Mat& picture, const Overlay& overlay, const Theme& theme, double unit) {
  Strip strip(picture, 0, topStripHeight(unit), theme, unit);
  const double margin = strip.px(24.0), right = strip.canvas.cols - margin;
  TextStyle faint = strip.letters(15.0);
  const std::string subtitle = fitText(overlay.subtitle, 0.5 * (right - margin), faint);
  const double subtitleLeft = right - textWidth(subtitle, faint);
  TextStyle bold = strip.letters(20.0, true);
  const std::string title = fitText(overlay.title, subtitleLeft - strip.px(36.0) - margin, bold);
  drawText(strip.canvas, title, margin, strip.middle(), bold);
  drawText(strip.canvas, subtitle, subtitleLeft, strip.middle(), faint);
}

/// Returns the right end.
double drawScaleBar(Strip& strip, const Camera& camera, const Theme& theme) {
  const ScaleBar bar = scaleBarFor(camera, 0.16 * camera.width);
  const double left = strip.px(24.0), right = left + bar.pixels;
  const double half = strip.px(2.0), tick = strip.px(9.0);
  strip.rectangle(left, strip.middle() - half, right, strip.middle() + half, theme.text);
  strip.rectangle(left, strip.middle() - tick, left + 2 * half, strip.middle() + tick, theme.text);
  strip.rectangle(right - 2 * half, strip.middle() - tick, right, strip.middle() + tick,
                  theme.text);
  const std::string caption =
      numberText(bar.metres) + (camera.perspective ? " m at the centre" : " m");
  return drawText(strip.canvas, caption, right + strip.px(14.0), strip.middle(),
                  strip.letters(15.0));
}

double drawScale(Strip& strip, const LegendScale& scale, double right) {
  const TextStyle style = strip.letters(15.0);
  const std::string low = numberText(scale.range.low), high = numberText(scale.range.high);
  const double gap = strip.px(12.0), length = strip.px(240.0), half = strip.px(9.0);
  double x = right - textWidth(high, style);
  drawText(strip.canvas, high, x, strip.middle(), style);
  x -= gap + length;
  const int columns = static_cast<int>(length);
  for (int column = 0; column < columns; ++column)
    strip.rectangle(x + column, strip.middle() - half, x + column + 1, strip.middle() + half,
                    rampColor(scale.ramp, column / (length - 1.0)));
  x -= gap + textWidth(low, style);
  drawText(strip.canvas, low, x, strip.middle(), style);
  x -= strip.px(20.0) + textWidth(scale.caption, style);
  drawText(strip.canvas, scale.caption, x, strip.middle(), style);
  return x - strip.px(40.0);
}

double drawEntry(Strip& strip, const LegendEntry& entry, double right) {
  const TextStyle style = strip.letters(15.0);
  const double edge = strip.px(18.0);
  double x = right - textWidth(entry.caption, style);
  drawText(strip.canvas, entry.caption, x, strip.middle(), style);
  x -= strip.px(10.0) + edge;
  strip.rectangle(x, strip.middle() - 0.5 * edge, x + edge, strip.middle() + 0.5 * edge,
                  entry.color);
  return x - strip.px(32.0);
}

/// Returns the left end.
double drawLegend(Strip strip, const Overlay& overlay, double right) {
  double left = right;
  if (overlay.scale) left = drawScale(strip, *overlay.scale, left);
  for (auto entry = overlay.entries.rbegin(); entry != overlay.entries.rend(); ++entry)
    left = drawEntry(strip, *entry, left);
  return left;
}

}  // namespace

Theme themeOf(Background background) {
  if (background == Background::Light)
    return {{250, 250, 250}, {232, 235, 239}, {28, 32, 38}, {70, 76, 84}};
  return {{13, 16, 21}, {26, 31, 39}, {238, 241, 245}, {178, 186, 196}};
}

ScaleBar scaleBarFor(const Camera& camera, double longest) {
  const double scale = camera.pixelsPerMetre(camera.distance);
  const double limit = longest / scale;
  const double power = std::pow(10.0, std::floor(std::log10(limit)));
  const double metres = limit >= 5.0 * power   ? 5.0 * power
                        : limit >= 2.0 * power ? 2.0 * power
                                               : power;
  return {metres, metres * scale};
}

PictureFrame mapFrame(int width, int height) {
  const double unit = unitOf(width, height), margin = 14.0 * unit;
  return {margin, topStripHeight(unit) + margin, width - margin,
          height - bottomStripHeight(unit) - margin};
}

void drawOverlay(cv::Mat& picture, const Overlay& overlay, const Camera& camera,
                 const Theme& theme) {
  const double unit = unitOf(picture.cols, picture.rows);
  drawTitles(picture, overlay, theme, unit);
  const int height = bottomStripHeight(unit), top = picture.rows - height;
  const double margin = 24.0 * unit, right = picture.cols - margin;
  cv::Mat measured(height, picture.cols, CV_8UC3);
  Strip trial(measured, 0, height, theme, unit);
  const double needed = right - drawLegend(trial, overlay, right);
  Strip strip(picture, top, height, theme, unit);
  const double available = right - drawScaleBar(strip, camera, theme) - margin;
  drawLegend(strip.shrunk(std::clamp(available / needed, 0.3, 1.0)), overlay, right);
}

}  // namespace toss
