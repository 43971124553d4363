// SPDX-License-Identifier: BSD-3-Clause
#include "ClaimGrid.h"

#include <toss/geometry/ProcessorVariants.h>

namespace toss {

TOSS_ALSO_FOR_AVX2
void ClaimGrid::findSquares(const float* __restrict x, const float* __restrict y, std::size_t n,
                            std::int32_t* __restrict square) {
  for (std::size_t i = 0; i < n; ++i) square[i] = squareOf(x[i], y[i]);
}

}  // namespace toss
