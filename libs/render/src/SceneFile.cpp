// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/opengl/COpenGLScene.h>
#include <mrpt/opengl/CSetOfLines.h>
#include <mrpt/opengl/CSetOfObjects.h>
#include <toss/rawlog/MetricMapFile.h>
#include <toss/render/SceneFile.h>

#include "LineDrawing.h"
#include "MapColoring.h"
#include "Picture.h"
#include "PointCloudObject.h"

namespace toss {
namespace {

mrpt::img::TColor toMrpt(const Color& color) {
  return {color.red, color.green, color.blue};
}

mrpt::opengl::CPointCloudColoured::Ptr makeCloud(const PointBatch& batch, const char* name) {
  auto cloud = toPointCloudObject(batch);
  cloud->setName(name);
  cloud->setPointSize(2.0f);
  cloud->enableVariablePointSize(false);
  return cloud;
}

class LineSet {
 public:
  LineSet(const std::string& name, const Color& color, const Eigen::Vector3d& origin)
      : lines_(mrpt::opengl::CSetOfLines::Create()), origin_(origin) {
    lines_->setName(name);
    lines_->setColor_u8(toMrpt(color));
    lines_->setLineWidth(2.0f);
  }
  void add(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    const Eigen::Vector3d a = from - origin_, b = to - origin_;
    lines_->appendLine(a.x(), a.y(), a.z(), b.x(), b.y(), b.z());
  }
  mrpt::opengl::CSetOfLines::Ptr get() const { return lines_; }

 private:
  mrpt::opengl::CSetOfLines::Ptr lines_;
  const Eigen::Vector3d& origin_;
};

mrpt::opengl::CSetOfLines::Ptr makeTrajectory(const std::vector<Eigen::Vector3d>& positions,
                                              const Eigen::Vector3d& origin) {
  LineSet lines("trajectory", {255, 255, 255}, origin);
  for (std::size_t i = 1; i < positions.size(); ++i) lines.add(positions[i - 1], positions[i]);
  return lines.get();
}

mrpt::opengl::CSetOfObjects::Ptr makeTracks(const std::vector<TrackPath>& tracks,
                                            const Eigen::Vector3d& origin) {
  auto group = mrpt::opengl::CSetOfObjects::Create();
  group->setName("moving_tracks");
  for (const TrackPath& path : tracks) {
    const std::string number = std::to_string(path.track);
    LineSet way("track_" + number + "_path", trackColor(path.track), origin);
    for (std::size_t i = 1; i < path.boxes.size(); ++i)
      way.add(path.boxes[i - 1].center, path.boxes[i].center);
    LineSet boxes("track_" + number + "_boxes", trackColor(path.track), origin);
    for (const Box& box : shownBoxes(path))
      for (const auto& [from, to] : edgesOf(box)) boxes.add(from, to);
    group->insert(way.get());
    group->insert(boxes.get());
  }
  return group;
}

void aimCamera(mrpt::opengl::COpenGLScene& scene, const Extent& extent,
               const Eigen::Vector3d& offset) {
  const auto viewport = scene.getViewport();
  const double size = extent.size().norm();
  const Eigen::Vector3d center = extent.center() + offset;
  viewport->setCustomBackgroundColor({0.05f, 0.06f, 0.08f, 1.0f});
  viewport->setViewportClipDistances(static_cast<float>(0.001 * size + 0.05),
                                     static_cast<float>(20.0 * size + 100.0));
  auto& camera = viewport->getCamera();
  camera.setPointingAt(mrpt::math::TPoint3D(center.x(), center.y(), center.z()));
  camera.setZoomDistance(static_cast<float>(1.5 * size + 1.0));
  camera.setAzimuthDegrees(-135.0f);
  camera.setElevationDegrees(40.0f);
}

}  // namespace

void writeScene(const MapContent& content, const std::filesystem::path& file,
                const RenderOptions& options) {
  options.check();
  const auto limit = static_cast<std::size_t>(options.sceneMaxPoints);
  const Extent extent = robustExtent(content.staticPoints);
  const Eigen::Vector3d origin = extent.center();
  const MapColoring coloring = colorStaticMap(content.staticPoints, PictureColor::Height);
  auto run = mrpt::opengl::CSetOfObjects::Create();
  run->setName("toss_run");
  const Eigen::Vector3d place = origin + content.offset;
  run->setLocation(place.x(), place.y(), place.z());
  run->insert(makeCloud(makeBatch(content.staticPoints, origin, limit, 0.1, coloring.colorOf),
                        "static_map"));
  run->insert(makeCloud(makeBatch(content.movingPoints, origin, limit, 0.1,
                                  [](const MapPoint&) { return kRemovedColor; }),
                        "removed_points"));
  run->insert(makeTrajectory(content.trajectory, origin));
  run->insert(makeTracks(content.tracks, origin));
  mrpt::opengl::COpenGLScene scene;
  scene.insert(run);
  aimCamera(scene, extent, content.offset);
  writeObjectFile(file, scene);
}

}  // namespace toss
