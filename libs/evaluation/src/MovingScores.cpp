// SPDX-License-Identifier: BSD-3-Clause
#include <toss/evaluation/MovingScores.h>
#include <toss/rawlog/LabelFile.h>

#include <algorithm>
#include <limits>

namespace toss {
namespace {

double ratio(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? std::numeric_limits<double>::quiet_NaN()
                    : static_cast<double>(part) / static_cast<double>(whole);
}

std::size_t bandOf(float range) {
  return static_cast<std::size_t>(rangeBand(range));
}

struct ObjectSum {
  std::uint64_t points = 0, called = 0;
  double range = 0.0;
};

}  // namespace

int rangeBand(float range) {
  return static_cast<int>(std::upper_bound(kRangeBandEnds.begin(), kRangeBandEnds.end(), range) -
                          kRangeBandEnds.begin());
}

const char* rangeBandName(int band) {
  static constexpr std::array<const char*, kRangeBands> names = {"0-20 m", "20-40 m", "40-60 m",
                                                                 "over 60 m"};
  return names.at(static_cast<std::size_t>(band));
}

void MovingCounts::add(bool moving, bool calledMoving) {
  truePositives += moving && calledMoving;
  falsePositives += !moving && calledMoving;
  falseNegatives += moving && !calledMoving;
}

double MovingCounts::intersectionOverUnion() const {
  return ratio(truePositives, truePositives + falsePositives + falseNegatives);
}
double MovingCounts::precision() const {
  return ratio(truePositives, truePositives + falsePositives);
}
double MovingCounts::recall() const {
  return ratio(truePositives, truePositives + falseNegatives);
}

void MovingScores::addScan(const std::vector<std::uint32_t>& truth,
                           const std::vector<std::uint32_t>& called,
                           const std::vector<float>& range) {
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const std::uint32_t trueClass = label::semantic(truth[i]);
    if (trueClass <= 1) continue;
    const bool moving = label::isMoving(truth[i]), calledMoving = label::isMoving(called[i]);
    all.add(moving, calledMoving);
    byRange[bandOf(range[i])].add(moving, calledMoving);
    ClassCounts& counts = byClass[trueClass];
    ++counts.points, counts.calledMoving += calledMoving;
  }
  addObjects(truth, called, range);
}

void MovingScores::addObjects(const std::vector<std::uint32_t>& truth,
                              const std::vector<std::uint32_t>& called,
                              const std::vector<float>& range) {
  std::map<std::uint32_t, ObjectSum> objects;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (!label::isMoving(truth[i]) || label::instance(truth[i]) == 0) continue;
    ObjectSum& sum = objects[truth[i]];
    ++sum.points, sum.called += label::isMoving(called[i]);
    sum.range += static_cast<double>(range[i]);
  }
  for (const auto& [object, sum] : objects) {
    const double meanRange = sum.range / static_cast<double>(sum.points);
    ObjectCounts& counts = objectsByRange[bandOf(static_cast<float>(meanRange))];
    ++counts.objects, counts.found += 2 * sum.called >= sum.points;
  }
}

}  // namespace toss
