// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

namespace toss {

/// How far neighbouring points lie apart [m]: the median over a few points of the distance to the
/// third nearest other one, which is the spacing of a regular surface and about that of a random
/// one; 0.1 for fewer than four points.
double pointSpacing(const std::vector<Eigen::Vector3f>& points);

}  // namespace toss
