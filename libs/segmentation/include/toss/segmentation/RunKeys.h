// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/segmentation/LinkRules.h>
#include <toss/segmentation/RowRuns.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace toss {

/// A key that several runs are compared with in one go.
#ifdef __SSE2__
using RunKey = __m128i;
inline RunKey runKey(std::uint16_t key) {
  return _mm_set1_epi16(static_cast<short>(key));
}
#else
using RunKey = std::uint16_t;
inline RunKey runKey(std::uint16_t key) {
  return key;
}
#endif

/// Where runs lie that may be linked to one run: at ranges nearest..farthest, or at ranges
/// surfaceNearest..surfaceFarthest in the columns first..last, where they may be of one surface
/// with it. Runs of its set are linked already. Numbers as in RunKeys.
struct RunVicinity {
  RunKey nearest, farthest, surfaceNearest, surfaceFarthest, first, last, set;
};

/// What tells runs that may be linked to a run from others at a glance, in 16 bits each, so that
/// many are looked at in one go. Ranges are rounded such that no run is missed.
class RunKeys {
 public:
  /// Runs that are looked at in one go.
  static constexpr std::int32_t kLanes = 8;

  void build(const RowRuns& runs, const LinkRules& rules);

  /// Vicinity of a run in its own row and in other rows. `set`: its own; `first`, `last`: its
  /// columns.
  RunVicinity withinRow(std::int32_t run, std::int32_t set) const {
    const auto r = static_cast<std::size_t>(run);
    const RunKey none = runKey(0);
    return {runKey(horizontal_.nearest[r]),
            runKey(horizontal_.farthest[r]),
            none,
            none,
            none,
            none,
            ofOwnSet(set)};
  }
  RunVicinity betweenRows(std::int32_t run, std::int32_t set, std::int32_t first,
                          std::int32_t last) const {
    const auto r = static_cast<std::size_t>(run);
    return {runKey(vertical_.nearest[r]),
            runKey(vertical_.farthest[r]),
            runKey(surface_.nearest[r]),
            runKey(surface_.farthest[r]),
            runKey(ofColumn(first - 1)),
            runKey(ofColumn(last + 1)),
            ofOwnSet(set)};
  }

  /// Sets the set of a run, which any of its members may stand for. Those of numbers too large are
  /// not told from each other, nor are they the set of any vicinity.
  void setSet(std::int32_t run, std::int32_t set) {
    set_[static_cast<std::size_t>(run)] = static_cast<std::uint16_t>(std::min(set, kLargeSet));
  }
  static RunKey ofOwnSet(std::int32_t set) {
    return runKey(static_cast<std::uint16_t>(set < kLargeSet ? set : kLargeSet + 1));
  }

  /// Bit k: whether run `first` + k lies in the vicinity, for kLanes runs; where there is no run,
  /// its bit means nothing. `withSurface`: or of one surface.
  template <bool withSurface>
  std::uint32_t inVicinity(std::int32_t first, const RunVicinity& vicinity) const;

 private:
  static constexpr std::int32_t kLargeSet = 65534;
  /// Ranges, shape [runs + kLanes].
  struct Rings {
    std::vector<std::uint16_t> nearest, farthest;
  };

  static std::uint16_t ofColumn(std::int32_t column) {
    return static_cast<std::uint16_t>(std::min(std::max(column, 0), 65535));
  }
  static void buildRings(const RowRuns& runs, const LinkRules::Distance& distance, Rings& rings);

  /// Ranges of the runs, and those that their link distances reach.
  Rings own_, horizontal_, vertical_, surface_;
  /// Shape [runs + kLanes].
  std::vector<std::uint16_t> firstColumn_, lastColumn_, set_;
};

#ifdef __SSE2__

template <bool withSurface>
std::uint32_t RunKeys::inVicinity(std::int32_t first, const RunVicinity& vicinity) const {
  const auto load = [first](const std::vector<std::uint16_t>& keys) {
    return _mm_loadu_si128(reinterpret_cast<const __m128i*>(keys.data() + first));
  };
  // Differences that saturate at zero are zero where nothing is exceeded.
  const auto outside = [](__m128i low, __m128i high, __m128i least, __m128i most) {
    return _mm_or_si128(_mm_subs_epu16(low, most), _mm_subs_epu16(least, high));
  };
  const __m128i zero = _mm_setzero_si128();
  const __m128i nearest = load(own_.nearest), farthest = load(own_.farthest);
  __m128i near =
      _mm_cmpeq_epi16(outside(nearest, farthest, vicinity.nearest, vicinity.farthest), zero);
  if (withSurface) {
    const __m128i far =
        outside(nearest, farthest, vicinity.surfaceNearest, vicinity.surfaceFarthest);
    const __m128i aside =
        outside(load(firstColumn_), load(lastColumn_), vicinity.first, vicinity.last);
    near = _mm_or_si128(near, _mm_cmpeq_epi16(_mm_or_si128(far, aside), zero));
  }
  near = _mm_andnot_si128(_mm_cmpeq_epi16(load(set_), vicinity.set), near);
  return static_cast<std::uint32_t>(_mm_movemask_epi8(_mm_packs_epi16(near, zero)));
}

#else

template <bool withSurface>
std::uint32_t RunKeys::inVicinity(std::int32_t first, const RunVicinity& vicinity) const {
  std::uint32_t bits = 0;
  for (std::size_t k = 0; k < static_cast<std::size_t>(kLanes); ++k) {
    const std::size_t run = static_cast<std::size_t>(first) + k;
    const std::uint16_t nearest = own_.nearest[run], farthest = own_.farthest[run];
    const bool near = nearest <= vicinity.farthest && farthest >= vicinity.nearest;
    const bool surface = nearest <= vicinity.surfaceFarthest &&
                         farthest >= vicinity.surfaceNearest &&
                         firstColumn_[run] <= vicinity.last && lastColumn_[run] >= vicinity.first;
    const bool candidate = (near || (withSurface && surface)) && set_[run] != vicinity.set;
    bits |= static_cast<std::uint32_t>(candidate) << k;
  }
  return bits;
}

#endif

}  // namespace toss
