// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <opencv2/core/mat.hpp>

namespace toss {

/// Writes a PNG that appears under its name when it is complete. Throws UserError if it can not be.
void writePicture(const std::filesystem::path& file, const cv::Mat& picture);

}  // namespace toss
