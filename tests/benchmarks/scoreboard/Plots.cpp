// SPDX-License-Identifier: BSD-3-Clause
#include "Plots.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <opencv2/imgproc.hpp>

#include "PlotStyle.h"
#include "ResultSummary.h"

namespace toss {
namespace {

constexpr int kWidth = 1280, kLeft = 210, kRight = 40, kTop = 70;

std::string toText(double value, const char* format) {
  char text[32];
  std::snprintf(text, sizeof(text), format, value);
  return text;
}

/// Horizontal bars on a scale from `low` to `high`.
class BarChart {
 public:
  BarChart(int rows, int rowHeight, double low, double high, const std::string& title)
      : image_(kTop + rows * rowHeight + 40, kWidth, CV_8UC3, cv::Scalar(255, 255, 255)),
        rowHeight_(rowHeight),
        low_(low),
        high_(high) {
    write(image_, title, 12, 24);
  }

  void grid(double step, const char* format) {
    for (double value = low_; value <= high_ + 0.5 * step; value += step) {
      cv::line(image_, {column(value), kTop - 8}, {column(value), image_.rows - 30}, kGrid);
      write(image_, toText(value, format), column(value) - 16, image_.rows - 12);
    }
  }
  void label(int row, const std::string& text) {
    write(image_, text, 12, kTop + row * rowHeight_ + rowHeight_ / 2 + 4);
  }
  /// Bar number `part` of `parts` in a row, from `from` to `to`.
  void bar(int row, int part, int parts, double from, double to, const cv::Scalar& color) {
    const int inner = rowHeight_ - 8, top = kTop + row * rowHeight_ + 4 + part * inner / parts;
    const int left = column(std::min(from, to)), right = column(std::max(from, to));
    cv::rectangle(image_, cv::Rect(left, top, std::max(right - left, 1), inner / parts - 1), color,
                  cv::FILLED);
  }
  void note(int row, double value, const std::string& text) {
    write(image_, text, column(value) + 6, kTop + row * rowHeight_ + rowHeight_ / 2 + 4);
  }
  void legend(int number, const std::string& text, const cv::Scalar& color) {
    const int x = kLeft + number * 200;
    cv::rectangle(image_, cv::Rect(x, 38, 14, 14), color, cv::FILLED);
    write(image_, text, x + 20, 50);
  }
  void save(const std::filesystem::path& file) const { savePlot(image_, file); }

 private:
  int column(double value) const {
    const double share = std::clamp((value - low_) / (high_ - low_), 0.0, 1.0);
    return kLeft + static_cast<int>(std::lround(share * (kWidth - kLeft - kRight)));
  }

  cv::Mat image_;
  int rowHeight_;
  double low_, high_;
};

void drawScenes(const std::vector<CaseResult>& results, const std::vector<Variant>& variants,
                const std::filesystem::path& file) {
  std::vector<const Variant*> shown;
  for (const Variant& v : variants)
    if (v.kind != VariantKind::Ablation && v.name != "naive") shown.push_back(&v);
  const std::vector<std::string> scenes = scenesWorstFirst(results);
  const int parts = static_cast<int>(shown.size());
  BarChart chart(static_cast<int>(scenes.size()), 14 * parts + 10, 0.0, 1.0, "F1 by scene");
  chart.grid(0.1, "%.1f");
  for (int part = 0; part < parts; ++part) {
    const Variant& variant = *shown[static_cast<std::size_t>(part)];
    const cv::Scalar& color = kColors[1 + part];
    chart.legend(part, variant.name, color);
    for (std::size_t row = 0; row < scenes.size(); ++row) {
      const SceneScore score = sceneScore(results, scenes[row], variant.name);
      if (score.seeds > 0) chart.bar(static_cast<int>(row), part, parts, 0.0, score.f1, color);
    }
  }
  for (std::size_t row = 0; row < scenes.size(); ++row)
    chart.label(static_cast<int>(row), scenes[row]);
  chart.save(file);
}

void drawAblation(const std::vector<CaseResult>& results, const std::vector<Variant>& variants,
                  const std::filesystem::path& file) {
  std::vector<const Variant*> shown;
  double extreme = 0.01;
  for (const Variant& v : variants) {
    if (v.kind != VariantKind::Ablation) continue;
    shown.push_back(&v);
    extreme = std::max(extreme, std::abs(differenceToDefault(results, v.name).f1));
  }
  BarChart chart(static_cast<int>(shown.size()), 28, -1.15 * extreme, 1.15 * extreme,
                 "Mean change of F1 when a part of TOSS is off or as in the paper");
  chart.grid(1.15 * extreme, "%+.3f");
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const int row = static_cast<int>(i);
    const double change = differenceToDefault(results, shown[i]->name).f1;
    chart.label(row, shown[i]->name);
    chart.bar(row, 0, 1, 0.0, change, change < 0.0 ? kColors[3] : kColors[2]);
    chart.note(row, std::max(change, 0.0), toText(change, "%+.4f"));
  }
  chart.save(file);
}

}  // namespace

void drawPlots(const std::vector<CaseResult>& results, const std::vector<Variant>& variants,
               const std::filesystem::path& folder) {
  drawScenes(results, variants, folder / "results_scenes.png");
  drawAblation(results, variants, folder / "results_ablation.png");
}

}  // namespace toss
