// SPDX-License-Identifier: BSD-3-Clause
#include "PlotStyle.h"

#include <toss/geometry/Error.h>
#include <toss/rawlog/AtomicFile.h>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

namespace toss {

void write(cv::Mat& image, const std::string& text, int x, int y) {
  cv::putText(image, text, {x, y}, cv::FONT_HERSHEY_SIMPLEX, 0.5, kInk, 1, cv::LINE_AA);
}

void savePlot(const cv::Mat& image, const std::filesystem::path& file) {
  writeAtomically(file, [&](const std::filesystem::path& path) {
    if (!cv::imwrite(path.string(), image))
      throw UserError(file.string(), "can not be written", "give another folder");
  });
}

}  // namespace toss
