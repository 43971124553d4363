// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "ClaimFootprint.h"

namespace toss {

/// A few returns that lie in one cell of the grid, which boxes are asked about together.
struct ClaimBatch {
  static constexpr std::size_t kMost = 16;
  template <typename T>
  using Lanes = std::array<T, kMost>;

  /// Level frame [m].
  Lanes<float> x{}, y{}, z{};
  /// The least that a box must take to claim each outright, as a number.
  Lanes<std::int32_t> least{};
  /// The first box that claims each outright, and as residue, -1 = none.
  Lanes<std::int32_t> outright{}, residue{};

  /// Starts anew with so many returns.
  void start(std::size_t returns) {
    lanes_ = (returns + kVector - 1) / kVector * kVector;
    outright.fill(-1), residue.fill(-1);
  }

  /// Growth of boxes to their sides and top [m], see BoxClaims::Margins.
  struct Margins {
    float claim, residue;
  };
  /// Asks box `number`, which takes that much, what it claims outright. Vectorised where it is
  /// inlined.
  [[gnu::always_inline]] inline void askOutright(const ClaimFootprint& box, std::int32_t number,
                                                 std::int32_t takes, const Margins& margins) {
    const std::size_t lanes = lanes_;
    for (std::size_t i = 0; i < lanes; ++i) {
      const int claims = holds(box, margins.claim, i) & static_cast<int>(takes >= least[i]);
      outright[i] = (claims & static_cast<int>(outright[i] < 0)) != 0 ? number : outright[i];
    }
  }
  /// The same for what it claims as residue.
  [[gnu::always_inline]] inline void askResidue(const ClaimFootprint& box, std::int32_t number,
                                                const Margins& margins) {
    const std::size_t lanes = lanes_;
    for (std::size_t i = 0; i < lanes; ++i) {
      const int claims = holds(box, margins.residue, i) & static_cast<int>(residue[i] < 0);
      residue[i] = claims != 0 ? number : residue[i];
    }
  }

 private:
  [[gnu::always_inline]] inline int holds(const ClaimFootprint& box, float margin,
                                          std::size_t i) const {
    const float dx = x[i] - box.x, dy = y[i] - box.y;
    const float along = std::fabs(box.cosYaw * dx + box.sinYaw * dy);
    const float across = std::fabs(box.cosYaw * dy - box.sinYaw * dx);
    return static_cast<int>(z[i] >= box.low) & static_cast<int>(z[i] <= box.high + margin) &
           static_cast<int>(along <= box.halfLength + margin) &
           static_cast<int>(across <= box.halfWidth + margin);
  }

  static constexpr std::size_t kVector = 8;
  /// Whole vectors, so that no single returns are left over.
  std::size_t lanes_ = 0;
};

}  // namespace toss
