// SPDX-License-Identifier: BSD-3-Clause
// How well an observation agrees with the map.
#include <mrpt/obs/CObservation.h>
#include <toss/mrpt/CDynamicFilteredPointsMap.h>
#include <toss/rawlog/MrptConversion.h>
#include <toss/rawlog/ObservationPoints.h>

#include <cmath>

#include "MapState.h"
#include "PlugInError.h"

namespace toss {
namespace {

using mrpt::maps::CPointsMapXYZI;

/// Mean squared distance [m^2] of every `step`-th return to the map, each at most `limit`; `limit`
/// where there is nothing to compare.
double meanSquaredDistance(const CPointsMapXYZI& map, const PointCloud& points,
                           const Eigen::Isometry3d& mapFromSensor, std::size_t step, double limit) {
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < points.size(); i += step) {
    const Eigen::Vector3d p(points.x[i], points.y[i], points.z[i]);
    if (!p.allFinite() || p.isZero()) continue;
    const Eigen::Vector3f inMap = (mapFromSensor * p).cast<float>();
    float squared = 0.0f;
    map.kdTreeClosestPoint3D(inMap.x(), inMap.y(), inMap.z(), squared);
    sum += std::min(static_cast<double>(squared), limit);
    ++count;
  }
  return count > 0 ? sum / static_cast<double>(count) : limit;
}

}  // namespace

bool CDynamicFilteredPointsMap::internal_canComputeObservationLikelihood(
    const mrpt::obs::CObservation& observation) const {
  return holdsPoints(observation);
}

double CDynamicFilteredPointsMap::internal_computeObservationLikelihood(
    const mrpt::obs::CObservation& observation, const mrpt::poses::CPose3D& takenFrom) const {
  if (!holdsPoints(observation)) return 0.0;
  const std::lock_guard<std::mutex> lock(state_->mutex);
  const CPointsMapXYZI& map = state_->present();
  PosedScan scan;
  passingUserErrors([&] {
    const std::string rawlog = insertionOptions.resolve("").plugin.rawlog;
    readObservation(observation, rawlog, scan);
    placeScan(observation, fromMrpt(takenFrom), "observation", scan);
  });
  const double limit = likelihoodOptions.max_corr_distance * likelihoodOptions.max_corr_distance;
  const std::size_t step = std::max<std::size_t>(1, likelihoodOptions.decimation);
  const double squared =
      map.empty() ? limit : meanSquaredDistance(map, scan.points, scan.mapFromSensor, step, limit);
  return -squared / likelihoodOptions.sigma_dist;
}

}  // namespace toss
