// SPDX-License-Identifier: BSD-3-Clause
#include <toss/render/PointSample.h>

#include <stdexcept>
#include <utility>

namespace toss {
namespace {

// Finaliser of splitmix64: every bit of the result depends on every bit of the number, so that a
// sample shows no pattern although the points of a map are ordered.
std::uint64_t mix(std::uint64_t number) {
  number += 0x9e3779b97f4a7c15u;
  number = (number ^ (number >> 30)) * 0xbf58476d1ce4e5b9u;
  number = (number ^ (number >> 27)) * 0x94d049bb133111ebu;
  return number ^ (number >> 31);
}

}  // namespace

PointSample::PointSample(std::size_t limit) : limit_(limit) {
  if (limit == 0) throw std::logic_error("PointSample: limit of 0");
}

bool PointSample::passes(std::uint64_t number) const {
  return halvings_ == 0 || mix(number) >> (64 - halvings_) == 0;
}

void PointSample::add(const MapPoint& point) {
  const std::uint64_t number = seen_++;
  if (!passes(number)) return;
  points_.push_back(point);
  numbers_.push_back(number);
  while (points_.size() > limit_) thin();
}

void PointSample::thin() {
  ++halvings_;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (!passes(numbers_[i])) continue;
    points_[kept] = points_[i];
    numbers_[kept++] = numbers_[i];
  }
  points_.resize(kept);
  numbers_.resize(kept);
}

std::vector<MapPoint> PointSample::take() {
  std::vector<MapPoint> taken = std::move(points_);
  *this = PointSample(limit_);
  return taken;
}

std::vector<std::uint32_t> sampleIndices(std::size_t n, std::size_t limit) {
  std::vector<std::uint32_t> indices;
  indices.reserve(n < limit ? n : limit);
  const double share = static_cast<double>(limit) / static_cast<double>(n ? n : 1);
  for (std::size_t i = 0; i < n && indices.size() < limit; ++i)
    if (share >= 1.0 || static_cast<double>(mix(i) >> 11) * 0x1p-53 < share)
      indices.push_back(static_cast<std::uint32_t>(i));
  return indices;
}

}  // namespace toss
