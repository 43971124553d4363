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
void findRings(const float* __restrict nearest, const float* __restrict farthest, std::size_t n,
               const LinkRules::Distance& distance, std::uint16_t* __restrict ringNearest,
               std::uint16_t* __restrict ringFarthest) {
  const LinkRules::Distance held = distance;
  for (std::size_t i = 0; i < n; ++i) {
    // A hair more, for rounding.
    const float limit = 1.001f * held.at(farthest[i]) + 1e-4f;
    ringNearest[i] = keyOfRange(nearest[i] - limit);
    ringFarthest[i] = keyOfRange(farthest[i] + limit);
  }
}

}  // namespace

void RunKeys::buildRings(const RowRuns& runs, const LinkRules::Distance& distance, Rings& rings) {
  const std::size_t n = runs.size(), padded = n + static_cast<std::size_t>(kLanes);
  rings.nearest.resize(padded), rings.farthest.resize(padded);
  findRings(runs.nearest.data(), runs.farthest.data(), n, distance, rings.nearest.data(),
            rings.farthest.data());
}

void RunKeys::build(const RowRuns& runs, const LinkRules& rules) {
  buildRings(runs, LinkRules::Distance::constant(0.0f), own_);
  buildRings(runs, LinkRules::Distance::constant(rules.surfaceDistance), surface_);
  buildRings(runs, rules.horizontal, horizontal_);
  buildRings(runs, rules.vertical, vertical_);
  const std::size_t n = runs.size(), padded = n + static_cast<std::size_t>(kLanes);
  firstColumn_.resize(padded), lastColumn_.resize(padded);
  set_.resize(padded);
  for (std::size_t run = 0; run < n; ++run) {
    firstColumn_[run] = ofColumn(runs.firstColumn[run]);
    lastColumn_[run] = ofColumn(runs.lastColumn[run]);
  }
}

}  // namespace toss
