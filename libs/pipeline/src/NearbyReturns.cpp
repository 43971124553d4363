// SPDX-License-Identifier: BSD-3-Clause
#include "NearbyReturns.h"

#include <algorithm>

namespace toss {
namespace {

constexpr int kSquares = NearbyReturns::kSquares;
constexpr std::size_t kBlock = 512;

/// Which mark of its square a return of each class needs, none for those never wanted.
std::array<std::uint8_t, 256> wantedMarks() {
  std::array<std::uint8_t, 256> wanted{};
  const auto set = [&](PointClass pointClass, NearbyReturns::Of what) {
    wanted[static_cast<std::size_t>(pointClass)] = static_cast<std::uint8_t>(what);
  };
  set(PointClass::Ground, NearbyReturns::Of::NoInstance);
  set(PointClass::Unclustered, NearbyReturns::Of::NoInstance);
  set(PointClass::Instance, NearbyReturns::Of::Instances);
  return wanted;
}

/// Number of a square along one axis; 0 for what is not a number.
std::int32_t along(float coordinate) {
  constexpr auto kLast = static_cast<float>(kSquares - 1);
  const float square = std::max(0.0f, coordinate + 0.5f * static_cast<float>(kSquares));
  return static_cast<std::int32_t>(std::min(square, kLast));
}

std::int32_t squareOf(float x, float y) {
  return along(x) * kSquares + along(y);
}

}  // namespace

void NearbyReturns::mark(const Eigen::AlignedBox2f& area, Of what) {
  if (area.isEmpty()) return;
  const std::int32_t width = along(area.max().y()) - along(area.min().y()) + 1;
  const std::int32_t end = squareOf(area.max().x(), area.min().y());
  const auto bit = static_cast<std::uint8_t>(what);
  for (std::int32_t first = squareOf(area.min().x(), area.min().y()); first <= end;
       first += kSquares) {
    std::uint8_t* const row = marks_.data() + first;
    for (std::int32_t square = 0; square < width; ++square) row[square] |= bit;
  }
}

void NearbyReturns::find(const LevelPoints& points, const std::vector<PointClass>& pointClass) {
  static const std::array<std::uint8_t, 256> wanted = wantedMarks();
  const std::size_t n = points.x.size();
  if (found_.size() < n) found_.resize(n);
  std::int32_t* const found = found_.data();
  std::size_t count = 0;
  std::array<std::int32_t, kBlock> square;
  for (std::size_t begin = 0; begin < n; begin += kBlock) {
    const std::size_t size = std::min(kBlock, n - begin);
    const float *const x = points.x.data() + begin, *const y = points.y.data() + begin;
    // A loop of its own, which the compiler vectorises.
    for (std::size_t i = 0; i < size; ++i) square[i] = squareOf(x[i], y[i]);
    // Without branches, as no one could foretell what is near.
    for (std::size_t i = 0; i < size; ++i) {
      const std::uint8_t mark = marks_[static_cast<std::size_t>(square[i])];
      found[count] = static_cast<std::int32_t>(begin + i);
      count += (mark & wanted[static_cast<std::size_t>(pointClass[begin + i])]) != 0 ? 1 : 0;
    }
  }
  count_ = count;
}

}  // namespace toss
