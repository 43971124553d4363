// SPDX-License-Identifier: BSD-3-Clause
#include "MotionSurvey.h"

#include <algorithm>
#include <cstdio>

#include "PoseFinding.h"

namespace toss {
namespace {

/// Scans of a stretch; the pause after it doubles every time.
constexpr std::uint64_t kStretch = 40;
/// Way during a sweep that shows in a map [m].
constexpr double kLeastSmear = 0.2;

}  // namespace

MotionSurvey::MotionSurvey(const OdometryOptions& options, bool posed)
    : options_(options), posed_(posed) {}

void MotionSurvey::begin() {
  odometry_.emplace(options_);
  givenFit_.emplace(options_);
  foundFit_.emplace(options_);
  stretches_.emplace_back();
  stretchBegin_ = count_;
}

void MotionSurvey::look(const PosedScan& scan) {
  timed_ = timed_ || !scan.points.time.empty();
  if (count_ == stretchBegin_ + pause_) begin();
  const std::uint64_t inStretch = count_++ - stretchBegin_;
  if (inStretch >= kStretch) {
    if (inStretch == kStretch) pause_ = 2 * std::max(pause_, kStretch);
    return;
  }
  MotionStretch& stretch = stretches_.back();
  stretch.times.push_back(scan.time);
  stretch.given.push_back(scan.mapFromSensor);
  stretch.found.push_back(odometry_->add(scan));
  if (!posed_) return;
  stretch.givenFit += givenFit_->add(scan, stretch.given.back());
  stretch.foundFit += foundFit_->add(scan, stretch.found.back());
}

void MotionSurvey::reportSweeps(Findings& findings) const {
  std::vector<double> ways;
  for (const MotionStretch& stretch : stretches_)
    for (std::size_t i = 1; i < stretch.found.size(); ++i)
      ways.push_back((stretch.found[i].translation() - stretch.found[i - 1].translation()).norm());
  if (timed_ || ways.empty()) return;
  const auto middle = ways.begin() + static_cast<std::ptrdiff_t>(ways.size() / 2);
  std::nth_element(ways.begin(), middle, ways.end());
  if (*middle < kLeastSmear) return;
  char text[200];
  std::snprintf(text, sizeof text,
                "returns carry no times, so it does not show whether the scans are de-skewed: if "
                "not, each is distorted by up to %.1f m",
                *middle);
  findings.push_back(
      {Severity::Note, "no-times", text,
       "de-skew them where they are recorded, import them with their times, or describe "
       "the sensor's sweep: input.deskew=sweep"});
}

void MotionSurvey::report(Findings& findings) const {
  if (posed_) reportPoses(judgePoses(stretches_), findings);
  reportSweeps(findings);
}

}  // namespace toss
