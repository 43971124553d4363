// SPDX-License-Identifier: BSD-3-Clause
#include "ScanSurvey.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace toss {
namespace {

/// Times between scans that are that many times the usual one are gaps.
constexpr double kGap = 2.5;
/// Scans that may be left out before the log is unfit.
constexpr double kLostShare = 0.1;

std::string percentOf(std::uint64_t part, std::uint64_t all) {
  char text[40];
  std::snprintf(text, sizeof text, "%.2g %%",
                all == 0 ? 0.0 : 100.0 * static_cast<double>(part) / static_cast<double>(all));
  return text;
}

std::string seconds(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.3f s", value);
  return text;
}

}  // namespace

void ScanSurvey::look(const PosedScan& scan) {
  times_.push_back(scan.time);
  if (sensor_.empty()) sensor_ = scan.sensorModel;
  const PointCloud& points = scan.points;
  empty_ += points.empty();
  returns_ += points.size();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const float sum = std::abs(points.x[i]) + std::abs(points.y[i]) + std::abs(points.z[i]);
    atOrigin_ += sum == 0.0f;
    notFinite_ += !std::isfinite(sum);
  }
}

void ScanSurvey::reportGaps(Findings& findings) const {
  if (times_.size() < 3) return;
  std::vector<double> steps;
  for (std::size_t i = 1; i < times_.size(); ++i) steps.push_back(times_[i] - times_[i - 1]);
  std::vector<double> sorted = steps;
  std::sort(sorted.begin(), sorted.end());
  const double usual = sorted[sorted.size() / 2];
  const auto isGap = [&](double step) { return step > kGap * usual; };
  const auto gaps = std::count_if(steps.begin(), steps.end(), isGap);
  if (gaps == 0) return;
  const auto first = std::find_if(steps.begin(), steps.end(), isGap) - steps.begin();
  findings.push_back(
      {Severity::Doubt, "time-gaps",
       std::to_string(gaps) + " gaps in time: scans come every " + seconds(usual) +
           ", the longest gap lasts " + seconds(sorted.back()) + ", the first begins at " +
           seconds(times_[static_cast<std::size_t>(first)]),
       "record on a faster disk, or map the parts apart with --from and --to if tracks break"});
}

void ScanSurvey::reportReturns(Findings& findings) const {
  if (empty_ > 0)
    findings.push_back({Severity::Doubt, "empty-scans",
                        std::to_string(empty_) + " scans hold no returns",
                        "check the cable and the driver of the sensor"});
  if (atOrigin_ > 0)
    findings.push_back({Severity::Note, "origin-returns",
                        percentOf(atOrigin_, returns_) +
                            " of the returns lie at the origin: beams that saw nothing",
                        "nothing is to be done: they are left out"});
  if (notFinite_ > 0)
    findings.push_back({Severity::Note, "not-finite",
                        percentOf(notFinite_, returns_) + " of the returns are not finite",
                        "nothing is to be done: they are left out"});
}

void ScanSurvey::report(const InputReport& report, Findings& findings) const {
  for (const std::string& warning : report.warnings)
    findings.push_back({Severity::Doubt, "input", warning, ""});
  const std::uint64_t lost = report.skippedForPose + report.skippedForTime;
  const std::uint64_t all = lost + scans();
  if (static_cast<double>(lost) > kLostShare * static_cast<double>(all))
    findings.push_back(
        {Severity::Fault, "scans-lost",
         std::to_string(lost) + " of " + std::to_string(all) +
             " scans are left out (no pose: " + std::to_string(report.skippedForPose) +
             ", out of order in time: " + std::to_string(report.skippedForTime) + ")",
         "sort the log by time, and give poses for all scans (--poses, --odometry)"});
  reportGaps(findings);
  reportReturns(findings);
  if (scans() > empty_ && sensor_.empty())
    findings.push_back({Severity::Doubt, "sensor",
                        "the sensor is not recognised: its beams are measured from a scan",
                        "name it with sensor.model if it is a known one"});
}

}  // namespace toss
