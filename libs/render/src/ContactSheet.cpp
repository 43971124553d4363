// SPDX-License-Identifier: BSD-3-Clause
#include <toss/geometry/Error.h>
#include <toss/render/ContactSheet.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "Overlay.h"
#include "PictureFile.h"
#include "TextDrawing.h"

namespace toss {
namespace {

constexpr int kMargin = 14, kCaptionHeight = 34, kTitleHeight = 48;

cv::Mat readScaled(const std::filesystem::path& file, int width) {
  const cv::Mat picture = cv::imread(file.string(), cv::IMREAD_COLOR);
  if (picture.empty())
    throw UserError(file.string(), "can not be read as a picture", "give PNG or JPEG files");
  const int height = std::max(
      1, static_cast<int>(std::lround(static_cast<double>(picture.rows) * width / picture.cols)));
  cv::Mat scaled;
  cv::resize(picture, scaled, {width, height}, 0, 0,
             width < picture.cols ? cv::INTER_AREA : cv::INTER_CUBIC);
  return scaled;
}

void putCell(cv::Mat& sheet, const cv::Mat& picture, const std::string& caption, cv::Point corner,
             int rowHeight, const Theme& theme) {
  const int down = corner.y + (rowHeight - picture.rows) / 2;
  picture.copyTo(sheet(cv::Rect(corner.x, down, picture.cols, picture.rows)));
  TextStyle style{13.0, theme.text, false};
  const std::string text = fitText(caption, picture.cols, style);
  drawText(sheet, text, corner.x + 0.5 * (picture.cols - textWidth(text, style)),
           corner.y + rowHeight + 0.5 * kCaptionHeight, style);
}

}  // namespace

void writeContactSheet(const std::vector<SheetEntry>& entries, const std::string& title,
                       int columns, int cellWidth, const std::filesystem::path& file) {
  if (columns < 1 || cellWidth < 64)
    throw std::logic_error("writeContactSheet: fewer than 1 column or 64 pixels");
  if (entries.empty())
    throw UserError(file.string(), "there is no picture to put on the sheet",
                    "give at least one picture");
  std::vector<cv::Mat> pictures;
  int rowHeight = 0;
  for (const SheetEntry& entry : entries) {
    pictures.push_back(readScaled(entry.file, cellWidth));
    rowHeight = std::max(rowHeight, pictures.back().rows);
  }
  const int used = std::min(columns, static_cast<int>(entries.size()));
  const int rows = (static_cast<int>(entries.size()) + used - 1) / used;
  const Theme theme = themeOf(Background::Light);
  cv::Mat sheet(kTitleHeight + rows * (rowHeight + kCaptionHeight) + kMargin,
                kMargin + used * (cellWidth + kMargin), CV_8UC3, toScalar(theme.background));
  TextStyle style{17.0, theme.text, true};
  const std::string shownTitle = fitText(title, sheet.cols - 2.0 * kMargin, style);
  drawText(sheet, shownTitle, kMargin, 0.5 * kTitleHeight, style);
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const int column = static_cast<int>(i) % used, row = static_cast<int>(i) / used;
    putCell(sheet, pictures[i], entries[i].caption,
            {kMargin + column * (cellWidth + kMargin),
             kTitleHeight + row * (rowHeight + kCaptionHeight)},
            rowHeight, theme);
  }
  writePicture(file, sheet);
}

}  // namespace toss
