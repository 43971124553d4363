// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/render/Camera.h>
#include <toss/render/Color.h>
#include <toss/render/RenderOptions.h>

#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <vector>

namespace toss {

/// Colours of what surrounds the map.
struct Theme {
  Color background, panel, text, faint;
};

Theme themeOf(Background background);

/// A colour scale with its ends and what it measures, e.g. "height [m]".
struct LegendScale {
  Ramp ramp = Ramp::Turbo;
  ValueRange range;
  std::string caption;
};

struct LegendEntry {
  Color color;
  std::string caption;
};

/// What is written above and below a map.
struct Overlay {
  std::string title, subtitle;
  std::optional<LegendScale> scale;
  std::vector<LegendEntry> entries;
};

/// Bar of a round number of metres (1, 2 or 5 times a power of ten).
struct ScaleBar {
  double metres = 0.0, pixels = 0.0;
};

/// The longest bar of at most `longest` pixels at the camera's target.
ScaleBar scaleBarFor(const Camera& camera, double longest);

/// The part of a picture between the strips that drawOverlay() fills.
PictureFrame mapFrame(int width, int height);

/// Draws a strip with the titles at the top, and one with scale bar and legend at the bottom.
void drawOverlay(cv::Mat& picture, const Overlay& overlay, const Camera& camera,
                 const Theme& theme);

}  // namespace toss
