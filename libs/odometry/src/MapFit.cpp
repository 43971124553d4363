// SPDX-License-Identifier: BSD-3-Clause
#include <toss/odometry/MapFit.h>
#include <toss/odometry/Registration.h>

#include "ScanThinning.h"

namespace toss {

MapFit::MapFit(const OdometryOptions& options)
    : options_(options), map_(options.effectiveVoxelSize(), options.pointsPerVoxel) {
  options.check();
}

double MapFit::add(const PosedScan& scan, const Eigen::Isometry3d& mapFromSensor) {
  // Alignment::fit: the kernel of 10 cm, and pairs as far apart as the map finds them.
  const RegistrationLimits limits = {options_.effectiveVoxelSize(), 0.01, 1, 1.0};
  takePoints(scan.points, options_, points_);
  thin(points_, options_, mapPoints_, sourcePoints_);
  const double fit = fitness(sourcePoints_, map_, mapFromSensor, limits);
  for (Eigen::Vector3d& point : mapPoints_) point = mapFromSensor * point;
  map_.add(mapPoints_, mapFromSensor.linear().col(2));
  map_.forgetBeyond(mapFromSensor.translation(), options_.maxRange);
  return fit;
}

}  // namespace toss
