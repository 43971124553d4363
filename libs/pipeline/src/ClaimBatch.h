// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "ClaimFootprint.h"
#include "ClaimReturns.h"

namespace toss {

/// A box as returns are held against it.
struct alignas(64) ClaimBox {
  /// How far it reaches: its top, and its sides from the middle [m, level frame].
  struct Reach {
    float high, halfLength, halfWidth;
    /// Of a footprint that is grown by `margin` [m].
    static Reach of(const ClaimFootprint& box, float margin) {
      return {box.high + margin, box.halfLength + margin, box.halfWidth + margin};
    }
    /// Nowhere.
    static Reach none() { return {0.0f, -1.0f, -1.0f}; }
  };
  float x, y, cosYaw, sinYaw, low;
  /// For what it claims outright, and as residue.
  Reach claim, residue;
  /// How much it takes, as a number; see BoxClaims::Claimant.
  std::int32_t takes, number;

  /// Of a footprint whose reaches and takes are to be set.
  static ClaimBox at(const ClaimFootprint& box, std::int32_t number) {
    return {box.x, box.y, box.cosYaw, box.sinYaw, box.low, Reach::none(), Reach::none(), 0, number};
  }
};

/// A few returns that lie in one cell of the grid, which boxes are asked about together: in vectors
/// of the compiler, as it does not keep arrays in registers.
struct ClaimBatch {
  static constexpr std::size_t kMost = 8;
  static_assert(kMost <= ClaimReturns::kSpare, "batches reach beyond the last return");
  using Floats = float __attribute__((vector_size(sizeof(float) * kMost)));
  using Numbers = std::int32_t __attribute__((vector_size(sizeof(std::int32_t) * kMost)));

  /// Level frame [m].
  Floats x, y, z;
  /// The least that a box must take to claim each outright.
  Numbers least;
  /// The first box that claims each outright, and as residue, -1 = none.
  Numbers outright, residue;

  /// Takes the returns from `first` on. `leastInInstance`: what a box must take to claim returns
  /// out of instances; `never`: more than any takes.
  [[gnu::always_inline]] inline void take(const ClaimReturns& returns, std::size_t first,
                                          std::int32_t leastInInstance, std::int32_t never) {
    Numbers way;
    std::memcpy(&x, returns.x.data() + first, sizeof x);
    std::memcpy(&y, returns.y.data() + first, sizeof y);
    std::memcpy(&z, returns.z.data() + first, sizeof z);
    std::memcpy(&way, returns.way.data() + first, sizeof way);
    const Numbers cut = way == static_cast<std::int32_t>(ClaimWay::Cut);
    const Numbers low = way == static_cast<std::int32_t>(ClaimWay::Residue);
    least = (cut & leastInInstance) | (low & never);
    outright = residue = Numbers{} - 1;
  }

  /// Asks a box what it claims, of what no box before has claimed.
  [[gnu::always_inline]] inline void ask(const ClaimBox& box) {
    constexpr std::int32_t kAllButSign = 0x7fffffff;
    const Floats dx = x - box.x, dy = y - box.y;
    const Floats ahead = box.cosYaw * dx + box.sinYaw * dy;
    const Floats aside = box.cosYaw * dy - box.sinYaw * dx;
    const auto along = reinterpret_cast<Floats>(reinterpret_cast<Numbers>(ahead) & kAllButSign);
    const auto across = reinterpret_cast<Floats>(reinterpret_cast<Numbers>(aside) & kAllButSign);
    const Numbers above = z >= box.low;
    const Numbers claimed = above & (z <= box.claim.high) & (along <= box.claim.halfLength) &
                            (across <= box.claim.halfWidth) & (least <= box.takes) & (outright < 0);
    const Numbers near = above & (z <= box.residue.high) & (along <= box.residue.halfLength) &
                         (across <= box.residue.halfWidth) & (residue < 0);
    outright = claimed ? Numbers{} + box.number : outright;
    residue = near ? Numbers{} + box.number : residue;
  }

  /// Writes the answers to the places of the returns; those behind the last of the cell mean
  /// nothing.
  [[gnu::always_inline]] inline void write(std::int32_t* outrightOf,
                                           std::int32_t* residueOf) const {
    std::memcpy(outrightOf, &outright, sizeof outright);
    std::memcpy(residueOf, &residue, sizeof residue);
  }
};

}  // namespace toss
