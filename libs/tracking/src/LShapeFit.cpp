// SPDX-License-Identifier: BSD-3-Clause
#include <toss/tracking/LShapeFit.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace toss {
namespace {

constexpr std::size_t kPointsUsed = 200;
/// Directions tried at first, and the finer ones tried around the best of them [rad].
constexpr double kDegree = M_PI / 180.0;
constexpr double kCoarseStep = 3.0 * kDegree, kFineStep = 0.5 * kDegree;
/// Points nearer than this to an edge lie on it [m].
constexpr float kOnEdge = 0.02f;

/// Distance of every value from the end of their range to which they are nearer on the whole.
void measureFromNearerEnd(std::vector<float>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const float least = *low, most = *high;
  double fromLeast = 0.0, fromMost = 0.0;
  for (const float value : values) {
    fromLeast += static_cast<double>((value - least) * (value - least));
    fromMost += static_cast<double>((most - value) * (most - value));
  }
  const bool useLeast = fromLeast <= fromMost;
  for (float& value : values) value = useLeast ? value - least : most - value;
}

class ClosenessSearch {
 public:
  ClosenessSearch(const std::vector<float>& x, const std::vector<float>& y) {
    const std::size_t stride = 1 + (x.size() - 1) / kPointsUsed;
    for (std::size_t i = 0; i < x.size(); i += stride) {
      x_.push_back(x[i] - x[0]);
      y_.push_back(y[i] - y[0]);
    }
    along_.resize(x_.size()), across_.resize(x_.size());
  }

  /// Best of the directions first, first + step, ... below `end`.
  void search(double first, double end, double step) {
    for (double angle = first; angle < end; angle += step) {
      const double score = closeness(angle);
      if (score <= bestScore_) continue;
      bestScore_ = score;
      best_ = angle;
    }
  }

  double best() const { return best_; }

 private:
  double closeness(double angle) {
    const float c = static_cast<float>(std::cos(angle)), s = static_cast<float>(std::sin(angle));
    for (std::size_t i = 0; i < x_.size(); ++i) {
      along_[i] = c * x_[i] + s * y_[i];
      across_[i] = c * y_[i] - s * x_[i];
    }
    measureFromNearerEnd(along_);
    measureFromNearerEnd(across_);
    return -sumOfLogarithms();
  }

  /// Logarithms are taken of products of 16 distances, which costs less and stays in range.
  double sumOfLogarithms() const {
    double sum = 0.0, product = 1.0;
    for (std::size_t i = 0; i < along_.size(); ++i) {
      product *= static_cast<double>(std::max(std::min(along_[i], across_[i]), kOnEdge));
      if (i % 16 != 15) continue;
      sum += std::log(product);
      product = 1.0;
    }
    return sum + std::log(product);
  }

  std::vector<float> x_, y_, along_, across_;
  double best_ = 0.0, bestScore_ = std::numeric_limits<double>::lowest();
};

}  // namespace

double fitLShape(const std::vector<float>& x, const std::vector<float>& y) {
  if (x.empty()) return 0.0;
  ClosenessSearch search(x, y);
  search.search(0.0, M_PI / 2 - 1e-9, kCoarseStep);
  const double coarse = search.best();
  search.search(coarse - kCoarseStep + kFineStep, coarse + kCoarseStep, kFineStep);
  const double angle = std::fmod(search.best() + M_PI / 2, M_PI / 2);
  return angle < M_PI / 2 ? angle : 0.0;
}

}  // namespace toss
