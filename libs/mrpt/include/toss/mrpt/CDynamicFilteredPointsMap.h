// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/maps/CMetricMap.h>
#include <mrpt/maps/CPointsMapXYZI.h>
#include <mrpt/version.h>
#include <toss/mrpt/FilteredMapOptions.h>

#include <memory>
#include <string>

namespace toss {

/// MRPT 2.11.3 made map definitions give smart pointers, and maps tell their bounding box.
#if MRPT_VERSION >= 0x020b03
#define TOSS_MRPT_HAS_MAP_BOUNDING_BOX 1
using CreatedMetricMap = std::shared_ptr<mrpt::maps::CMetricMap>;
#else
#define TOSS_MRPT_HAS_MAP_BOUNDING_BOX 0
using CreatedMetricMap = mrpt::maps::CMetricMap*;
#endif

/// A metric map of MRPT that holds what stays: LiDAR scans go in with the robot's poses, and what
/// moves is left out, as `toss map` does it. For use in an mrpt::maps::CMultiMetricMap under the
/// name dynamicFilteredPointsMap; see share/doc/plug-in.md.
///
/// Takes the observations that libs/rawlog reads as points (holdsPoints()), of one or several
/// LiDARs, those of each in order of time. The result for a scan is revised for some seconds after
/// it has come in. Calls of const members may run at the same time; what they refer to is valid
/// until the next call that is not const or that renews the map.
class CDynamicFilteredPointsMap : public mrpt::maps::CMetricMap {
  DEFINE_SERIALIZABLE(CDynamicFilteredPointsMap, toss)

 public:
  CDynamicFilteredPointsMap();
  ~CDynamicFilteredPointsMap() override;
  /// A copy starts with the present map, as if it had been loaded from a file.
  CDynamicFilteredPointsMap(const CDynamicFilteredPointsMap& other);
  CDynamicFilteredPointsMap& operator=(const CDynamicFilteredPointsMap& other);

  /// Options of the method. Changes have effect on a map that is empty or finished.
  FilteredMapOptions insertionOptions;
  /// Those of mrpt::maps::CPointsMap, here for all kinds of observations that hold points.
  mrpt::maps::CPointsMap::TLikelihoodOptions likelihoodOptions;

  /// Decides about the scans of the last seconds as well: from now on the map is what `toss map`
  /// writes for the same scans. Observations that come later start anew, with no memory of what
  /// was seen before, and their result is added. Called by serialization and by
  /// saveMetricMapRepresentationToFile().
  void finish() const;
  /// The map by present knowledge, map frame [m], intensity as in the observations; while
  /// observations come in, at most PlugInOptions::refreshScans old.
  const mrpt::maps::CPointsMapXYZI& points() const;

  /// Whether no return has been inserted.
  bool isEmpty() const override;
  std::string asString() const override;
  /// One point cloud, coloured by height.
  void getVisualizationInto(mrpt::opengl::CSetOfObjects& target) const override;
  /// Writes <prefix>.ply and <prefix>.metricmap, as `toss map` does.
  void saveMetricMapRepresentationToFile(const std::string& prefix) const override;
  /// points() without intensities. Changes of it do not come back.
  const mrpt::maps::CSimplePointsMap* getAsSimplePointsMap() const override;
  using CMetricMap::getAsSimplePointsMap;
  void determineMatching2D(const mrpt::maps::CMetricMap* other, const mrpt::poses::CPose2D& pose,
                           mrpt::tfest::TMatchingPairList& pairs,
                           const mrpt::maps::TMatchingParams& parameters,
                           mrpt::maps::TMatchingExtraResults& results) const override;
  void determineMatching3D(const mrpt::maps::CMetricMap* other, const mrpt::poses::CPose3D& pose,
                           mrpt::tfest::TMatchingPairList& pairs,
                           const mrpt::maps::TMatchingParams& parameters,
                           mrpt::maps::TMatchingExtraResults& results) const override;
  float compute3DMatchingRatio(const mrpt::maps::CMetricMap* other,
                               const mrpt::poses::CPose3D& pose,
                               const mrpt::maps::TMatchingRatioParams& parameters) const override;
  float squareDistanceToClosestCorrespondence(float x, float y) const override;
#if TOSS_MRPT_HAS_MAP_BOUNDING_BOX
  mrpt::math::TBoundingBoxf boundingBox() const override;
#endif

  MAP_DEFINITION_START(CDynamicFilteredPointsMap)
  toss::FilteredMapOptions insertionOpts;
  mrpt::maps::CPointsMap::TLikelihoodOptions likelihoodOpts;
  MAP_DEFINITION_END(CDynamicFilteredPointsMap)

 private:
  struct State;

  void internal_clear() override;
  bool internal_insertObservation(
      const mrpt::obs::CObservation& observation,
      const std::optional<const mrpt::poses::CPose3D>& robotPose) override;
  bool internal_canComputeObservationLikelihood(
      const mrpt::obs::CObservation& observation) const override;
  double internal_computeObservationLikelihood(
      const mrpt::obs::CObservation& observation,
      const mrpt::poses::CPose3D& takenFrom) const override;

  std::unique_ptr<State> state_;
};

}  // namespace toss
