// SPDX-License-Identifier: BSD-3-Clause
// Matching of the map with other maps, for MRPT's registration.
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/poses/CPose2D.h>
#include <toss/mrpt/CDynamicFilteredPointsMap.h>

namespace toss {
namespace {

using mrpt::maps::CMetricMap;
using mrpt::maps::CPointsMap;
using mrpt::maps::CSimplePointsMap;

/// The points of a map in the one class with which all matchings of MRPT work: given a
/// CPointsMapXYZI, compute3DMatchingRatio() of 2.5.8 follows a null pointer. Null for maps of
/// another kind. `copy` keeps what had to be converted.
const CSimplePointsMap* simplePoints(const CMetricMap* map, CSimplePointsMap& copy) {
  if (map == nullptr) return nullptr;
  if (const CSimplePointsMap* simple = map->getAsSimplePointsMap()) return simple;
  const auto* points = dynamic_cast<const CPointsMap*>(map);
  if (points == nullptr) return nullptr;
  copy = *points;
  return &copy;
}

}  // namespace

void CDynamicFilteredPointsMap::determineMatching2D(
    const CMetricMap* other, const mrpt::poses::CPose2D& pose,
    mrpt::tfest::TMatchingPairList& pairs, const mrpt::maps::TMatchingParams& parameters,
    mrpt::maps::TMatchingExtraResults& results) const {
  CSimplePointsMap copy;
  pairs.clear();
  if (const CSimplePointsMap* simple = simplePoints(other, copy); simple && !simple->empty())
    points().determineMatching2D(simple, pose, pairs, parameters, results);
}

void CDynamicFilteredPointsMap::determineMatching3D(
    const CMetricMap* other, const mrpt::poses::CPose3D& pose,
    mrpt::tfest::TMatchingPairList& pairs, const mrpt::maps::TMatchingParams& parameters,
    mrpt::maps::TMatchingExtraResults& results) const {
  CSimplePointsMap copy;
  pairs.clear();
  if (const CSimplePointsMap* simple = simplePoints(other, copy); simple && !simple->empty())
    points().determineMatching3D(simple, pose, pairs, parameters, results);
}

float CDynamicFilteredPointsMap::compute3DMatchingRatio(
    const CMetricMap* other, const mrpt::poses::CPose3D& pose,
    const mrpt::maps::TMatchingRatioParams& parameters) const {
  CSimplePointsMap copy;
  const CSimplePointsMap* simple = simplePoints(other, copy);
  return simple && !simple->empty() ? points().compute3DMatchingRatio(simple, pose, parameters)
                                    : 0.0f;
}

float CDynamicFilteredPointsMap::squareDistanceToClosestCorrespondence(float x, float y) const {
  return points().squareDistanceToClosestCorrespondence(x, y);
}

}  // namespace toss
