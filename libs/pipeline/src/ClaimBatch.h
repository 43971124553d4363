// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "ClaimFootprint.h"

namespace toss {

/// A few returns that lie in one cell of the grid, which boxes are asked about together.
struct ClaimBatch {
  static constexpr std::size_t kMost = 8;
  template <typename T>
  using Lanes = std::array<T, kMost>;

  /// Level frame [m].
  Lanes<float> x{}, y{}, z{};
  /// The least that a box must take to claim each outright, as a number.
  Lanes<std::int32_t> least{};
  /// The first box that claims each outright, and as residue, -1 = none.
  Lanes<std::int32_t> outright{}, residue{};

  /// Starts anew.
  void start() { outright.fill(-1), residue.fill(-1); }

  /// Growth of boxes to their sides and top [m], see BoxClaims::Margins.
  struct Margins {
    float claim, residue;
  };
  /// Asks box `number`, which takes that much, what it claims outright, and as residue if it
  /// `claimsResidue`. Vectorised where it is inlined.
  [[gnu::always_inline]] inline void ask(const ClaimFootprint& box, std::int32_t number,
                                         std::int32_t takes, bool claimsResidue,
                                         const Margins& margins) {
    const std::int32_t residueNumber = claimsResidue ? number : -1;
    for (std::size_t i = 0; i < kMost; ++i) {
      const float dx = x[i] - box.x, dy = y[i] - box.y;
      const float along = std::fabs(box.cosYaw * dx + box.sinYaw * dy);
      const float across = std::fabs(box.cosYaw * dy - box.sinYaw * dx);
      const auto holds = [&](float margin) {
        return static_cast<int>(z[i] >= box.low) & static_cast<int>(z[i] <= box.high + margin) &
               static_cast<int>(along <= box.halfLength + margin) &
               static_cast<int>(across <= box.halfWidth + margin);
      };
      const int takesIt = holds(margins.claim) & static_cast<int>(takes >= least[i]);
      outright[i] = (takesIt & static_cast<int>(outright[i] < 0)) != 0 ? number : outright[i];
      const int near = holds(margins.residue) & static_cast<int>(residue[i] < 0);
      residue[i] = near != 0 ? residueNumber : residue[i];
    }
  }
};

}  // namespace toss
