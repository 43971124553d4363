// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <opencv2/core.hpp>
#include <string>

namespace toss {

/// Colours that stay apart for the colour-blind (Okabe and Ito), blue-green-red.
inline const cv::Scalar kColors[] = {{153, 153, 153}, {66, 228, 240}, {0, 159, 230},
                                     {178, 114, 0},   {115, 158, 0},  {167, 121, 204}};
/// Of text and of grid lines.
inline const cv::Scalar kInk(40, 40, 40), kGrid(220, 220, 220);

/// Writes on an image, from the left end of the base line [pixels].
void write(cv::Mat& image, const std::string& text, int x, int y);

/// Saves an image. Throws UserError where it can not be written.
void savePlot(const cv::Mat& image, const std::filesystem::path& file);

}  // namespace toss
