// SPDX-License-Identifier: BSD-3-Clause
#include "AssociationPlot.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "PlotStyle.h"
#include "ResultSummary.h"

namespace toss {
namespace {

constexpr int kWidth = 960, kHeight = 640, kLeft = 100, kRight = 40, kTop = 120, kBottom = 70;
constexpr double kLeastSize = 20.0, kMostSize = 4000.0;

/// A sheet with logarithmic axes: traces to the right, milliseconds upwards in whole decades.
class LogarithmicChart {
 public:
  LogarithmicChart(int lowDecade, int highDecade)
      : image_(kHeight, kWidth, CV_8UC3, cv::Scalar(255, 255, 255)),
        low_(lowDecade),
        high_(highDecade) {
    write(image_, "Time to associate boxes with traces, median [ms], by number of traces", 12, 24);
    for (int decade = low_; decade <= high_; ++decade) drawDecade(decade);
    for (int size = 25; size < kMostSize; size *= 2) drawSize(size);
  }

  void curve(int number, const AssociationCurve& curve, const cv::Scalar& color) {
    cv::Point last;
    for (std::size_t i = 0; i < curve.sizes.size(); ++i) {
      const cv::Point point(column(curve.sizes[i]), row(curve.milliseconds[i]));
      if (i > 0) cv::line(image_, last, point, color, 2, cv::LINE_AA);
      cv::circle(image_, point, 4, color, cv::FILLED, cv::LINE_AA);
      last = point;
    }
    const int y = 52 + number * 22;
    cv::line(image_, {kLeft, y - 4}, {kLeft + 26, y - 4}, color, 3);
    write(image_, curve.method + ": grows as N^" + numberText(curve.exponent, 2), kLeft + 36, y);
  }

  const cv::Mat& image() const { return image_; }

 private:
  static int column(double size) {
    const double share = std::log(size / kLeastSize) / std::log(kMostSize / kLeastSize);
    return kLeft + static_cast<int>(std::lround(share * (kWidth - kLeft - kRight)));
  }
  int row(double milliseconds) const {
    const double share = (std::log10(milliseconds) - low_) / (high_ - low_);
    return kHeight - kBottom - static_cast<int>(std::lround(share * (kHeight - kTop - kBottom)));
  }
  void drawDecade(int decade) {
    const double value = std::pow(10.0, decade);
    cv::line(image_, {kLeft, row(value)}, {kWidth - kRight, row(value)}, kGrid);
    write(image_, numberText(value, std::max(-decade, 0)), 24, row(value) + 5);
  }
  void drawSize(int size) {
    const int x = column(size);
    cv::line(image_, {x, kTop}, {x, kHeight - kBottom}, kGrid);
    write(image_, std::to_string(size), x - 14, kHeight - kBottom + 24);
  }

  cv::Mat image_;
  int low_, high_;
};

}  // namespace

void drawAssociation(const AssociationStudy& study, const std::filesystem::path& file) {
  double least = 1.0, most = 1.0;
  for (const AssociationCurve& curve : study.curves)
    for (const double time : curve.milliseconds)
      least = std::min(least, time), most = std::max(most, time);
  LogarithmicChart chart(static_cast<int>(std::floor(std::log10(least))),
                         std::max(static_cast<int>(std::ceil(std::log10(most))), 1));
  constexpr int kColorOfMethod[] = {4, 3, 2};
  for (std::size_t i = 0; i < study.curves.size(); ++i)
    chart.curve(static_cast<int>(i), study.curves[i], kColors[kColorOfMethod[i % 3]]);
  savePlot(chart.image(), file);
}

}  // namespace toss
