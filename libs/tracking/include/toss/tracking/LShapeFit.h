// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace toss {

/// Direction [rad], in [0, pi/2), of a side of the rectangle that best explains the points (x, y)
/// [m] as returns from two of its sides: the direction whose points lie closest to the nearer of
/// two perpendicular edges, by the sum of log(1 / max(d, 2 cm)) (spec section 4.2). Of large
/// clusters, about 200 points spread over the order given are looked at. 0 for no points.
double fitLShape(const std::vector<float>& x, const std::vector<float>& y);

}  // namespace toss
