// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/odometry/Registration.h>

namespace toss {

/// Where the second scan lies, while no velocity is known: of the places within `reach` [m] of
/// `last` (map <- sensor of the first scan) the one from which the points [m, sensor frame] align
/// best to the map. `limits`: of the alignment.
Eigen::Isometry3d findStart(const std::vector<Eigen::Vector3d>& points, const LocalMap& map,
                            const Eigen::Isometry3d& last, double reach,
                            const RegistrationLimits& limits);

}  // namespace toss
