// SPDX-License-Identifier: BSD-3-Clause
#include <toss/geometry/Error.h>
#include <toss/geometry/MarkedWords.h>
#include <toss/geometry/ProcessorVariants.h>
#include <toss/segmentation/RowAssignment.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace toss {
namespace {

constexpr float kPi = 3.14159265358979f;
constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();
constexpr std::size_t kLookUpCells = 4096;
/// Medians are taken over every so manieth return: good to a tenth of a beam, and cheap.
constexpr std::size_t kSampling = 8;
/// Fewest samples of a ring from which its elevation is measured.
constexpr std::size_t kMinSamples = 20;
/// Rings that may be missing from a scan in ring order.
constexpr int kMissingRings = 2;
/// A ring with less than this part of the average ring's returns is none.
constexpr std::size_t kShortRing = 20;

/// Azimuth from 0 to a whole turn.
float turned(float azimuth) {
  return azimuth < 0.0f ? azimuth + 2.0f * kPi : azimuth;
}

/// Marks returns that are not valid, and those where the azimuth wraps from the return before. The
/// compiler vectorises it only as a function of arrays that are known not to overlap.
TOSS_ALSO_FOR_AVX2
void markWraps(const float* __restrict azimuth, const std::uint8_t* __restrict valid, std::size_t n,
               std::uint8_t* __restrict mark) {
  mark[0] = 1;
  for (std::size_t i = 1; i < n; ++i) {
    const bool wraps = turned(azimuth[i - 1]) - turned(azimuth[i]) > kPi;
    mark[i] = static_cast<std::uint8_t>((valid[i] == 0) | (valid[i - 1] == 0) | wraps);
  }
}

float median(std::vector<float>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

RowAssignment::RowAssignment(const SensorModel& sensor, RowPolicy policy)
    : sensor_(sensor), policy_(policy) {
  if (sensor.rows() < 1 || sensor.rows() >= 65535) {
    throw UserError("sensor '" + sensor.name + "'", "it has no usable table of beams",
                    "name one of the known sensors");
  }
  std::vector<float> slopes;
  for (const float elevation : sensor.elevations) slopes.push_back(std::tan(elevation));
  for (std::size_t row = 0; row + 1 < slopes.size(); ++row) {
    boundary_.push_back(std::tan(0.5f * (sensor.elevations[row] + sensor.elevations[row + 1])));
  }
  topSlope_ = slopes.front();
  const float spread = std::max(slopes.front() - slopes.back(), 1e-6f);
  cellsPerSlope_ = static_cast<float>(kLookUpCells - 1) / spread;
  std::size_t row = 0;
  for (std::size_t cell = 0; cell < kLookUpCells; ++cell) {
    const float upperEdge = topSlope_ - static_cast<float>(cell) / cellsPerSlope_;
    while (row < boundary_.size() && boundary_[row] > upperEdge) ++row;
    firstRow_.push_back(static_cast<std::uint16_t>(row));
  }
}

RowSource RowAssignment::assign(const Directions& directions,
                                const std::vector<std::uint16_t>& ring,
                                std::vector<std::uint16_t>& row, std::vector<float>& elevations) {
  row.assign(directions.valid.size(), 0);
  elevations = sensor_.elevations;
  if (policy_ == RowPolicy::Equation) {
    fromEquation(directions, row);
    return RowSource::Equation;
  }
  if (policy_ == RowPolicy::Automatic && ring.size() == row.size() && !ring.empty()) {
    const int highest = *std::max_element(ring.begin(), ring.end());
    if (highest >= sensor_.rows()) {
      throw UserError("scan",
                      "it has a return of ring " + std::to_string(highest) + ", but sensor '" +
                          sensor_.name + "' has " + std::to_string(sensor_.rows()) + " beams",
                      "name the sensor that recorded it, or set projection.row_source=elevation");
    }
    row = ring;
    findMedianSlopes(directions, row);
    measureElevations(elevations);
    return RowSource::Ring;
  }
  if (policy_ == RowPolicy::Automatic && fromOrder(directions, row)) {
    measureElevations(elevations);
    return RowSource::Order;
  }
  fromElevation(directions, row);
  return RowSource::Elevation;
}

bool RowAssignment::fromOrder(const Directions& directions, std::vector<std::uint16_t>& row) {
  const int count = findRings(directions);
  if (count < std::max(1, sensor_.rows() - kMissingRings) || count > sensor_.rows()) return false;
  for (std::size_t ring = 0; ring + 1 < ringBegin_.size(); ++ring) {
    std::fill(row.begin() + static_cast<std::ptrdiff_t>(ringBegin_[ring]),
              row.begin() + static_cast<std::ptrdiff_t>(ringBegin_[ring + 1]),
              static_cast<std::uint16_t>(ring));
  }
  findMedianSlopes(directions, row);
  medians_.resize(static_cast<std::size_t>(count));
  for (std::size_t r = 1; r < medians_.size(); ++r) {
    if (!(medians_[r] < medians_[r - 1])) return false;
  }
  const int shift = shiftToTable();
  if (shift > 0) {
    for (std::uint16_t& r : row) r = static_cast<std::uint16_t>(r + shift);
  }
  medians_.insert(medians_.begin(), static_cast<std::size_t>(shift), kUnknown);
  medians_.resize(static_cast<std::size_t>(sensor_.rows()), kUnknown);
  return true;
}

/// Returns at which a turn begins. Only a few of them need a closer look.
void RowAssignment::findWraps(const Directions& directions) {
  const std::size_t n = directions.valid.size();
  ringBegin_.clear();
  if (n == 0) return;
  mark_.assign((n + kMarksInWord - 1) / kMarksInWord * kMarksInWord, 0);
  markWraps(directions.azimuth.data(), directions.valid.data(), n, mark_.data());
  float previous = std::numeric_limits<float>::infinity();
  std::size_t next = 0;
  visitMarkedWords(mark_.data(), mark_.size(), [&](std::size_t first) {
    // Between the words all returns are valid, and none wraps.
    if (first > next) previous = turned(directions.azimuth[first - 1]);
    next = std::min(first + kMarksInWord, n);
    for (std::size_t i = first; i < next; ++i) {
      if (directions.valid[i] == 0) continue;
      const float own = turned(directions.azimuth[i]);
      if (previous - own > kPi) ringBegin_.push_back(i);
      previous = own;
    }
  });
}

int RowAssignment::findRings(const Directions& directions) {
  findWraps(directions);
  if (ringBegin_.empty()) return 0;
  ringBegin_.front() = 0;
  ringBegin_.push_back(directions.valid.size());
  // A few returns between two wraps are jitter at the start of a ring, or at the scan's end.
  const std::size_t fewest = directions.valid.size() / sensor_.elevations.size() / kShortRing;
  std::size_t kept = 0;
  for (std::size_t ring = 0; ring + 1 < ringBegin_.size(); ++ring) {
    const std::size_t begin = kept == 0 ? 0 : ringBegin_[ring];
    if (ringBegin_[ring + 1] - begin > fewest) ringBegin_[kept++] = begin;
  }
  ringBegin_[kept] = directions.valid.size();
  ringBegin_.resize(kept + 1);
  return static_cast<int>(kept);
}

/// Where rings are missing, they are those that leave the others nearest to the sensor's table.
int RowAssignment::shiftToTable() const {
  int best = 0;
  float leastError = std::numeric_limits<float>::infinity();
  for (std::size_t shift = 0; shift + medians_.size() <= sensor_.elevations.size(); ++shift) {
    float error = 0.0f;
    for (std::size_t r = 0; r < medians_.size(); ++r) {
      error += std::fabs(std::atan(medians_[r]) - sensor_.elevations[r + shift]);
    }
    if (error < leastError) leastError = error, best = static_cast<int>(shift);
  }
  return best;
}

void RowAssignment::fromElevation(const Directions& directions,
                                  std::vector<std::uint16_t>& row) const {
  const auto last = static_cast<float>(kLookUpCells - 1);
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (directions.valid[i] == 0) continue;
    const float slope = directions.slope[i];
    const float cell = std::clamp((topSlope_ - slope) * cellsPerSlope_, 0.0f, last);
    std::size_t r = firstRow_[static_cast<std::size_t>(cell)];
    while (r < boundary_.size() && boundary_[r] > slope) ++r;
    row[i] = static_cast<std::uint16_t>(r);
  }
}

void RowAssignment::fromEquation(const Directions& directions,
                                 std::vector<std::uint16_t>& row) const {
  const float down = sensor_.elevations.back();
  const float field = std::max(sensor_.elevations.front() - down, 1e-6f);
  const auto rows = static_cast<float>(sensor_.rows());
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (directions.valid[i] == 0) continue;
    const float v = (1.0f - (std::atan(directions.slope[i]) - down) / field) * rows;
    row[i] = static_cast<std::uint16_t>(std::clamp(v, 0.0f, rows - 1.0f));
  }
}

void RowAssignment::findMedianSlopes(const Directions& directions,
                                     const std::vector<std::uint16_t>& row) {
  samples_.resize(static_cast<std::size_t>(sensor_.rows()));
  for (std::vector<float>& samples : samples_) samples.clear();
  for (std::size_t i = 0; i < row.size(); i += kSampling) {
    if (directions.valid[i] != 0) samples_[row[i]].push_back(directions.slope[i]);
  }
  medians_.clear();
  for (std::vector<float>& samples : samples_)
    medians_.push_back(samples.size() >= kMinSamples ? median(samples) : kUnknown);
}

void RowAssignment::measureElevations(std::vector<float>& elevations) const {
  std::vector<float> measured = sensor_.elevations;
  for (std::size_t r = 0; r < medians_.size(); ++r) {
    if (std::isfinite(medians_[r])) measured[r] = std::atan(medians_[r]);
  }
  // A table that is not in order would break every search in it.
  if (std::is_sorted(measured.rbegin(), measured.rend())) elevations = measured;
}

}  // namespace toss
