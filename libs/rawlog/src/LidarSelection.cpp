// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/obs/CObservation.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <toss/geometry/Error.h>
#include <toss/rawlog/LidarSelection.h>
#include <toss/rawlog/MrptConversion.h>
#include <toss/rawlog/ObservationPoints.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "RawlogReader.h"

namespace toss {
namespace {

using mrpt::obs::CObservation;

constexpr std::chrono::milliseconds kWindow(600);
/// Scans of one sensor that are looked at.
constexpr std::size_t kScans = 8;
/// Scans of all sensors that are looked through.
constexpr int kMostScans = 100;
constexpr std::size_t kFewestReturns = 200;
/// Two LiDARs can't be nearer to each other [m].
constexpr double kSamePlace = 0.01;
/// The same return in two observations: distance [m], and share of a sample that must be there.
constexpr float kSameReturn = 2e-3f;
constexpr std::size_t kSample = 200;
constexpr double kSameShare = 0.5;

/// The first scans of a sensor, as they are in the log.
struct Candidate {
  std::string label;
  std::vector<CObservation::Ptr> scans;
  std::vector<std::string> places;
  /// The first of them with enough returns, robot frame [m], shape [3, n].
  Eigen::Matrix3Xf returns;
  Eigen::Isometry3d robotFromSensor = Eigen::Isometry3d::Identity();
  mrpt::Clock::time_point time;
  /// Why it can't be read, "" where it can.
  std::string fault;
};

/// Gathers the scans of the beginning.
class Beginning {
 public:
  explicit Beginning(const std::filesystem::path& rawlog) : reader_(rawlog) {
    while (!over_) {
      const auto object = readObject();
      if (const auto observation = std::dynamic_pointer_cast<CObservation>(object))
        take(observation);
      else if (const auto frame = std::dynamic_pointer_cast<mrpt::obs::CSensoryFrame>(object))
        for (const auto& entry : *frame) take(entry);
      over_ = over_ || !object;
    }
  }
  std::vector<Candidate>& candidates() { return candidates_; }

 private:
  /// Damage is told by whoever reads the log for its scans.
  mrpt::serialization::CSerializable::Ptr readObject() {
    try {
      return reader_.next();
    } catch (const UserError&) {
      return nullptr;
    }
  }

  void take(const CObservation::Ptr& observation) {
    if (!observation || !holdsPoints(*observation)) return;
    if (candidates_.empty()) first_ = observation->timestamp;
    if (observation->timestamp > first_ + kWindow) over_ = true;
    auto found = std::find_if(candidates_.begin(), candidates_.end(), [&](const Candidate& each) {
      return each.label == observation->sensorLabel;
    });
    if (found == candidates_.end()) {
      candidates_.emplace_back();
      candidates_.back().label = observation->sensorLabel;
      found = std::prev(candidates_.end());
    }
    // Scans without time stamps tell no end.
    if (++taken_ >= kMostScans) over_ = true;
    if (found->scans.size() >= kScans) return;
    found->scans.push_back(observation);
    found->places.push_back(reader_.place());
  }

  RawlogReader reader_;
  std::vector<Candidate> candidates_;
  mrpt::Clock::time_point first_;
  int taken_ = 0;
  bool over_ = false;
};

Eigen::Matrix3Xf returnsOf(const PointCloud& points, const Eigen::Isometry3d& robotFromSensor) {
  Eigen::Matrix3Xf all(3, static_cast<Eigen::Index>(points.size()));
  Eigen::Index n = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3f p(points.x[i], points.y[i], points.z[i]);
    if (p.allFinite() && !p.isZero(0.0f)) all.col(n++) = robotFromSensor.cast<float>() * p;
  }
  return all.leftCols(n);
}

/// Reads its first scan with enough returns; false where there is none.
bool load(const std::filesystem::path& rawlog, Candidate& candidate) {
  for (std::size_t i = 0; i < candidate.scans.size(); ++i) try {
      PosedScan scan;
      const CObservation::Ptr& observation = candidate.scans[i];
      readPoints(*observation, rawlog, candidate.places[i], scan);
      placeScan(*observation, Eigen::Isometry3d::Identity(), candidate.places[i], scan);
      candidate.robotFromSensor = scan.robotFromSensor;
      candidate.time = observation->timestamp;
      candidate.returns = returnsOf(scan.points, scan.robotFromSensor);
      if (candidate.returns.cols() >= static_cast<Eigen::Index>(kFewestReturns)) return true;
    } catch (const UserError& error) {
      candidate.fault = error.what();
      return false;
    }
  return false;
}

bool sitAtOnePlace(const Candidate& a, const Candidate& b) {
  const auto offset = a.robotFromSensor.translation() - b.robotFromSensor.translation();
  return offset.norm() < kSamePlace;
}

/// Share of a sample of the returns of `some` that are among those of `all`.
double sharedReturns(const Eigen::Matrix3Xf& some, const Eigen::Matrix3Xf& all) {
  const Eigen::Index step = std::max<Eigen::Index>(1, some.cols() / static_cast<int>(kSample));
  std::size_t found = 0, asked = 0;
  for (Eigen::Index i = 0; i < some.cols(); i += step, ++asked) {
    const float nearest = (all.colwise() - some.col(i)).colwise().squaredNorm().minCoeff();
    found += nearest < kSameReturn * kSameReturn;
  }
  return static_cast<double>(found) / static_cast<double>(asked);
}

/// Why `candidate` holds nothing that `chosen` does not; "" where it does.
std::string reasonAgainst(const Candidate& candidate, const Candidate& chosen) {
  if (sitAtOnePlace(candidate, chosen))
    return "sits where '" + chosen.label +
           "' does: the same sensor in another form, or its sensor pose is missing";
  const bool fewer = candidate.returns.cols() < chosen.returns.cols();
  const Candidate &some = fewer ? candidate : chosen, &all = fewer ? chosen : candidate;
  if (some.time == all.time && sharedReturns(some.returns, all.returns) > kSameShare)
    return "holds the returns of '" + chosen.label + "'";
  return "";
}

std::string leftOut(const Candidate& candidate, const std::string& reason) {
  return "the scans of '" + candidate.label + "' are left out, it " + reason +
         " (input.sensor_label chooses it alone)";
}

void choose(const std::filesystem::path& input, std::vector<Candidate>& candidates,
            LidarSelection& selection) {
  std::vector<const Candidate*> chosen;
  for (Candidate& candidate : candidates) {
    std::string reason;
    if (!load(input, candidate))
      reason = candidate.fault.empty()
                   ? "has no scan of " + std::to_string(kFewestReturns) + " returns"
                   : "can't be read: " + candidate.fault;
    for (const Candidate* other : chosen)
      if (reason.empty()) reason = reasonAgainst(candidate, *other);
    if (reason.empty())
      chosen.push_back(&candidate);
    else
      selection.notes.push_back(leftOut(candidate, reason));
  }
  for (const Candidate* candidate : chosen) selection.labels.push_back(candidate->label);
}

}  // namespace

LidarSelection selectLidars(const std::filesystem::path& input, const InputOptions& options) {
  LidarSelection selection;
  std::error_code ignored;
  if (!options.sensorLabel.empty() || std::filesystem::is_directory(input, ignored))
    return selection;
  Beginning beginning(input);
  if (beginning.candidates().size() < 2) return selection;
  choose(input, beginning.candidates(), selection);
  // Where none is fit, the first one met is read as ever, and its faults are told.
  if (selection.labels.empty()) return {};
  return selection;
}

InputOptions withSelectedLidars(const std::filesystem::path& input, const InputOptions& options) {
  InputOptions result = options;
  if (result.sensorLabels.empty()) result.sensorLabels = selectLidars(input, options).labels;
  return result;
}

}  // namespace toss
