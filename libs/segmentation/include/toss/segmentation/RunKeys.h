// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/segmentation/LinkRules.h>
#include <toss/segmentation/RowRuns.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace toss {

/// Keys of half the runs that are looked at in one go: what a register of any processor holds.
using RunKeyLanes [[gnu::vector_size(16)]] = std::int16_t;

/// Where runs lie that may be linked to one run: at ranges nearest..farthest, or at ranges
/// surfaceNearest..surfaceFarthest in the columns first..last, where they may be of one surface
/// with it. Runs of its set are linked already. Keys as in RunKeys, the same in all lanes.
struct RunVicinity {
  RunKeyLanes nearest, farthest, set;
  RunKeyLanes surfaceNearest = {}, surfaceFarthest = {}, first = {}, last = {};
};

/// What tells runs that may be linked to a run from others at a glance, in 16 bits each, so that
/// many are looked at in one go. Ranges are rounded such that no run is missed.
class RunKeys {
 public:
  /// Runs that are looked at in one go.
  static constexpr std::int32_t kLanes = 16;

  void build(const RowRuns& runs);

  /// Sets where runs lie that links of a distance may join to one with ranges nearest..farthest
  /// [m].
  static void setRanges(float nearest, float farthest, const LinkRules::Distance& distance,
                        RunVicinity& vicinity) {
    const float limit = withHair(distance.at(farthest));
    vicinity.nearest = spread(ofRange(nearest - limit));
    vicinity.farthest = spread(ofRange(farthest + limit));
  }
  /// The same for runs of one surface up to `distance` [m] and next to the columns first..last.
  static void setSurface(float nearest, float farthest, float distance, std::int32_t first,
                         std::int32_t last, RunVicinity& vicinity) {
    const float limit = withHair(distance);
    vicinity.surfaceNearest = spread(ofRange(nearest - limit));
    vicinity.surfaceFarthest = spread(ofRange(farthest + limit));
    vicinity.first = spread(ofColumn(first - 1));
    vicinity.last = spread(ofColumn(last + 1));
  }
  /// Sets the set that a run belongs to itself.
  static void setOwnSet(std::int32_t set, RunVicinity& vicinity) {
    const auto key = static_cast<std::int16_t>(set < kLargeSet ? set : kLargeSet + 1);
    vicinity.set = spread(key);
  }

  /// Sets the set of a run, which any of its members may stand for. Those of numbers too large are
  /// not told from each other, nor are they the set of any vicinity.
  void setSet(std::int32_t run, std::int32_t set) {
    set_[static_cast<std::size_t>(run)] = static_cast<std::int16_t>(std::min(set, kLargeSet));
  }

  /// Bit k: whether run `first` + k lies in the vicinity, for kLanes runs; where there is no run,
  /// its bit means nothing. `withSurface`: or of one surface.
  template <bool withSurface>
  std::uint32_t inVicinity(std::int32_t first, const RunVicinity& vicinity) const {
    return bitsOf(halfInVicinity<withSurface>(first, vicinity),
                  halfInVicinity<withSurface>(first + kHalf, vicinity));
  }

 private:
  static constexpr std::int32_t kHalf = kLanes / 2;
  static constexpr std::int32_t kLargeSet = 65534;
  /// Finer than any link distance; ranges beyond 512 m are not told from each other.
  static constexpr float kStepsPerMetre = 128.0f;
  static constexpr std::int32_t kLeast = -32768, kMost = 32767;

  static std::int16_t ofRange(float range) {
    const float steps = std::min(std::max(range * kStepsPerMetre, 0.0f), 65535.0f);
    return static_cast<std::int16_t>(static_cast<std::int32_t>(steps) + kLeast);
  }
  static std::int16_t ofColumn(std::int32_t column) {
    return static_cast<std::int16_t>(std::min(std::max(column + kLeast, kLeast), kMost));
  }
  /// A hair more than a distance, for rounding.
  static float withHair(float distance) { return 1.001f * distance + 1e-4f; }

  static RunKeyLanes spread(std::int16_t key) {
    return RunKeyLanes{key, key, key, key, key, key, key, key};
  }
  static RunKeyLanes load(const std::vector<std::int16_t>& keys, std::int32_t first) {
    RunKeyLanes lanes;
    std::memcpy(&lanes, keys.data() + first, sizeof(lanes));
    return lanes;
  }

  template <bool withSurface>
  RunKeyLanes halfInVicinity(std::int32_t first, const RunVicinity& vicinity) const {
    const RunKeyLanes nearest = load(nearest_, first), farthest = load(farthest_, first);
    RunKeyLanes outside = (nearest > vicinity.farthest) | (farthest < vicinity.nearest);
    if (withSurface) {
      outside &= (nearest > vicinity.surfaceFarthest) | (farthest < vicinity.surfaceNearest) |
                 (load(firstColumn_, first) > vicinity.last) |
                 (load(lastColumn_, first) < vicinity.first);
    }
    return ~(outside | (load(set_, first) == vicinity.set));
  }

  /// One bit of each lane; all bits of a lane are the same.
  static std::uint32_t bitsOf(const RunKeyLanes& low, const RunKeyLanes& high) {
#ifdef __SSE2__
    const __m128i packed = _mm_packs_epi16(reinterpret_cast<const __m128i&>(low),
                                           reinterpret_cast<const __m128i&>(high));
    return static_cast<std::uint32_t>(_mm_movemask_epi8(packed));
#else
    std::uint32_t bits = 0;
    for (int lane = 0; lane < kHalf; ++lane) {
      bits |= (low[lane] & 1u) << lane | (high[lane] & 1u) << (lane + kHalf);
    }
    return bits;
#endif
  }

  /// Ranges, columns and sets of the runs, shape [runs + kLanes].
  std::vector<std::int16_t> nearest_, farthest_, firstColumn_, lastColumn_, set_;
};

}  // namespace toss
