// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/opengl/CPointCloudColoured.h>
#include <mrpt/opengl/CSetOfObjects.h>
#include <toss/mrpt/CDynamicFilteredPointsMap.h>
#include <toss/rawlog/MetricMapFile.h>
#include <toss/rawlog/MrptConversion.h>
#include <toss/rawlog/ObservationPoints.h>
#include <toss/rawlog/PlyFile.h>

#include "MapState.h"
#include "PlugInError.h"

namespace toss {
namespace {

using mrpt::maps::CMetricMap;
using mrpt::maps::CPointsMapXYZI;

std::vector<MapPoint> toMapPoints(const CPointsMapXYZI& map) {
  std::vector<MapPoint> points(map.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    map.getPointFast(i, points[i].x, points[i].y, points[i].z);
    points[i].intensity = map.getPointIntensity_fast(i);
  }
  return points;
}

}  // namespace

CDynamicFilteredPointsMap::CDynamicFilteredPointsMap() : state_(std::make_unique<State>()) {}

CDynamicFilteredPointsMap::~CDynamicFilteredPointsMap() = default;

CDynamicFilteredPointsMap::CDynamicFilteredPointsMap(const CDynamicFilteredPointsMap& other)
    : CMetricMap(), state_(std::make_unique<State>()) {
  *this = other;
}

CDynamicFilteredPointsMap& CDynamicFilteredPointsMap::operator=(
    const CDynamicFilteredPointsMap& other) {
  if (this == &other) return *this;
  auto points = std::make_shared<CPointsMapXYZI>(other.points());
  const std::lock_guard<std::mutex> lock(state_->mutex);
  genericMapParams = other.genericMapParams;
  insertionOptions = other.insertionOptions;
  likelihoodOptions = other.likelihoodOptions;
  state_->reset(std::move(points));
  return *this;
}

void CDynamicFilteredPointsMap::finish() const {
  const std::lock_guard<std::mutex> lock(state_->mutex);
  passingUserErrors([&] { state_->finish(); });
}

const CPointsMapXYZI& CDynamicFilteredPointsMap::points() const {
  const std::lock_guard<std::mutex> lock(state_->mutex);
  return state_->present();
}

bool CDynamicFilteredPointsMap::isEmpty() const {
  const std::lock_guard<std::mutex> lock(state_->mutex);
  return state_->kept->empty() && (!state_->session || state_->session->scanCount() == 0);
}

std::string CDynamicFilteredPointsMap::asString() const {
  const std::lock_guard<std::mutex> lock(state_->mutex);
  const std::uint64_t scans = state_->session ? state_->session->scanCount() : 0;
  return "Dynamic-filtered map: " + std::to_string(state_->kept->size()) + " points, and " +
         std::to_string(scans) + " scans that are being decided about";
}

void CDynamicFilteredPointsMap::getVisualizationInto(mrpt::opengl::CSetOfObjects& target) const {
  if (!genericMapParams.enableSaveAs3DObject) return;
  const std::lock_guard<std::mutex> lock(state_->mutex);
  const CPointsMapXYZI& map = state_->present();
  if (map.empty()) return;
  auto cloud = mrpt::opengl::CPointCloudColoured::Create();
  cloud->loadFromPointsMap(&map);
  std::vector<float> heights(map.getPointsBufferRef_z().begin(), map.getPointsBufferRef_z().end());
  const auto quantile = [&](std::size_t percent) {
    const auto place =
        heights.begin() + static_cast<std::ptrdiff_t>(heights.size() * percent / 100);
    std::nth_element(heights.begin(), place, heights.end());
    return *place;
  };
  const float low = quantile(2);
  cloud->recolorizeByCoordinate(low, std::max(low + 1.0f, quantile(98)), 2);
  cloud->setName("dynamicFilteredPointsMap");
  cloud->setPointSize(2.0f);
  target.insert(cloud);
}

void CDynamicFilteredPointsMap::saveMetricMapRepresentationToFile(const std::string& prefix) const {
  const std::lock_guard<std::mutex> lock(state_->mutex);
  passingUserErrors([&] {
    state_->finish();
    writePly(prefix + ".ply", toMapPoints(*state_->kept));
    writeObjectFile(prefix + ".metricmap", *state_->kept);
  });
}

const mrpt::maps::CSimplePointsMap* CDynamicFilteredPointsMap::getAsSimplePointsMap() const {
  const std::lock_guard<std::mutex> lock(state_->mutex);
  return &state_->presentSimple();
}

#if TOSS_MRPT_HAS_MAP_BOUNDING_BOX
mrpt::math::TBoundingBoxf CDynamicFilteredPointsMap::boundingBox() const {
  return points().boundingBox();
}
#endif

void CDynamicFilteredPointsMap::internal_clear() {
  const std::lock_guard<std::mutex> lock(state_->mutex);
  state_->reset(CPointsMapXYZI::Create());
}

bool CDynamicFilteredPointsMap::internal_insertObservation(
    const mrpt::obs::CObservation& observation,
    const std::optional<const mrpt::poses::CPose3D>& robotPose) {
  if (!holdsPoints(observation)) return false;
  const Eigen::Isometry3d mapFromRobot =
      robotPose ? fromMrpt(*robotPose) : Eigen::Isometry3d::Identity();
  const std::lock_guard<std::mutex> lock(state_->mutex);
  return passingUserErrors([&] {
    if (!state_->session) state_->session = std::make_unique<MappingSession>(insertionOptions);
    return state_->session->insert(observation, mapFromRobot);
  });
}

}  // namespace toss
