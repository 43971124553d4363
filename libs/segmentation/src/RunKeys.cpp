// SPDX-License-Identifier: BSD-3-Clause
#include <toss/segmentation/RunKeys.h>

namespace toss {
namespace {

/// Finer than any link distance; ranges beyond 512 m are not told from each other.
constexpr float kStepsPerMetre = 128.0f;

std::uint16_t keyOfRange(float range) {
  const float steps = std::min(std::max(range * kStepsPerMetre, 0.0f), 65535.0f);
  return static_cast<std::uint16_t>(static_cast<std::int32_t>(steps));
}

// The compiler vectorises this only as a function of arrays that are known not to overlap.
void findRings(const float* __restrict nearest, const float* __restrict farthest,
               const float* __restrict distance, std::size_t n,
               std::uint16_t* __restrict ringNearest, std::uint16_t* __restrict ringFarthest) {
  for (std::size_t i = 0; i < n; ++i) {
    // A hair more, for rounding.
    const float limit = 1.001f * distance[i] + 1e-4f;
    ringNearest[i] = keyOfRange(nearest[i] - limit);
    ringFarthest[i] = keyOfRange(farthest[i] + limit);
  }
}

}  // namespace

void RunKeys::buildRings(const RowRuns& runs, const std::vector<float>& distance, Rings& rings) {
  const std::size_t n = runs.size(), padded = n + static_cast<std::size_t>(kLanes);
  rings.nearest.resize(padded), rings.farthest.resize(padded);
  findRings(runs.nearest.data(), runs.farthest.data(), distance.data(), n, rings.nearest.data(),
            rings.farthest.data());
}

void RunKeys::build(const RowRuns& runs, float surface) {
  const std::size_t n = runs.size(), padded = n + static_cast<std::size_t>(kLanes);
  constant_.assign(n, 0.0f);
  buildRings(runs, constant_, own_);
  constant_.assign(n, surface);
  buildRings(runs, constant_, surface_);
  buildRings(runs, runs.reaches.horizontal, horizontal_);
  buildRings(runs, runs.reaches.vertical, vertical_);
  firstColumn_.resize(padded), lastColumn_.resize(padded), set_.resize(padded);
  for (std::size_t run = 0; run < n; ++run) {
    firstColumn_[run] = ofColumn(runs.firstColumn[run]);
    lastColumn_[run] = ofColumn(runs.lastColumn[run]);
  }
}

}  // namespace toss
