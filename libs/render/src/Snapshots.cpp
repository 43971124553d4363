// SPDX-License-Identifier: BSD-3-Clause
#include <toss/geometry/Error.h>
#include <toss/render/Snapshots.h>

#include <algorithm>
#include <system_error>

#include "MapColoring.h"
#include "Picture.h"

namespace toss {
namespace {

std::size_t limitOf(const RenderOptions& options) {
  return static_cast<std::size_t>(options.maxPoints);
}

std::string titleOf(const std::string& what, const std::string& name) {
  return name.empty() ? what : what + " - " + name;
}

/// Everything that the pictures of a run share.
Picture emptyPicture(const MapContent& content) {
  Picture picture;
  picture.subject =
      subjectOf(content.staticPoints.empty() ? content.movingPoints : content.staticPoints,
                content.trajectory);
  picture.scene.origin = picture.subject.extent.center();
  if (content.trajectory.size() > 1) picture.trajectory = &content.trajectory;
  return picture;
}

void addTrajectoryEntry(Picture& picture, const RenderOptions& options) {
  if (picture.trajectory)
    picture.overlay.entries.push_back({themeOf(options.background).text, "trajectory"});
}

Picture staticPicture(const MapContent& content, const RenderOptions& options) {
  Picture picture = emptyPicture(content);
  MapColoring coloring = colorStaticMap(content.staticPoints, options.color);
  picture.scene.batches = {makeBatch(content.staticPoints, picture.scene.origin, limitOf(options),
                                     0.0, coloring.colorOf)};
  picture.overlay.title = titleOf("Static map", content.name);
  picture.overlay.subtitle =
      countText(std::max<std::size_t>(content.staticCount, content.staticPoints.size()), "point") +
      ", " + sizeText(picture.subject.extent);
  addTrajectoryEntry(picture, options);
  picture.overlay.scale = coloring.scale;
  return picture;
}

void addMoving(Picture& picture, const MapContent& content, const RenderOptions& options) {
  const bool alone = content.staticPoints.empty();
  PointBatch moving = makeBatch(content.movingPoints, picture.scene.origin, limitOf(options),
                                alone ? 0.0 : picture.scene.batches.front().size,
                                [](const MapPoint&) { return kRemovedColor; });
  moving.emphasis = 1.4;
  picture.scene.batches.push_back(std::move(moving));
  if (!content.tracks.empty()) picture.tracks = &content.tracks;
}

Picture removedPicture(const MapContent& content, const RenderOptions& options) {
  Picture picture = emptyPicture(content);
  // It would hide what was removed ahead of the sensor.
  picture.trajectory = nullptr;
  const MapColoring coloring = colorStaticMap(content.staticPoints, PictureColor::Class);
  picture.scene.batches = {makeBatch(content.staticPoints, picture.scene.origin, limitOf(options),
                                     0.0, coloring.colorOf)};
  addMoving(picture, content, options);
  picture.overlay.title = titleOf("Removed from the map", content.name);
  picture.overlay.subtitle =
      countText(content.movingPoints.size(), "point") + " removed, " +
      countText(std::max<std::size_t>(content.trackCount, content.tracks.size()), "moving trace");
  picture.overlay.entries = {{kStaticColor, "static"}, {kRemovedColor, "removed"}};
  return picture;
}

}  // namespace

void renderSnapshots(const MapContent& content, const std::filesystem::path& folder,
                     const RenderOptions& options) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    throw UserError(folder.string(), "can not be made (" + error.message() + ")",
                    "choose another folder to write to");
  inRenderThread([&] {
    PictureDrawer drawer(options);
    drawer.draw(staticPicture(content, options), {{View::Top, folder / kSnapshotNames[0]},
                                                  {View::Chase, folder / kSnapshotNames[1]}});
    drawer.draw(removedPicture(content, options), {{View::Top, folder / kSnapshotNames[2]},
                                                   {View::Chase, folder / kSnapshotNames[3]}});
  });
}

void renderPicture(const MapContent& content, View view, const std::filesystem::path& file,
                   const RenderOptions& options) {
  inRenderThread([&] {
    PictureDrawer drawer(options);
    const bool byClass = options.color == PictureColor::Class;
    Picture picture = byClass ? removedPicture(content, options) : staticPicture(content, options);
    if (byClass) picture.overlay.title = titleOf("Map", content.name);
    drawer.draw(picture, {{view, file}});
  });
}

void renderErrors(const ErrorContent& content, View view, const std::filesystem::path& file,
                  const RenderOptions& options) {
  Picture picture;
  picture.subject = subjectOf(content.keptStatic, {});
  picture.scene.origin = picture.subject.extent.center();
  const MapColoring coloring = colorStaticMap(content.keptStatic, PictureColor::Class);
  picture.scene.batches = {
      makeBatch(content.keptStatic, picture.scene.origin, limitOf(options), 0.0, coloring.colorOf)};
  const double size = picture.scene.batches.front().size;
  const auto add = [&](const std::vector<MapPoint>& points, const Color& color, double emphasis,
                       const std::string& caption) {
    PointBatch batch = makeBatch(points, picture.scene.origin, limitOf(options), size,
                                 [&](const MapPoint&) { return color; });
    batch.emphasis = emphasis;
    picture.scene.batches.push_back(std::move(batch));
    picture.overlay.entries.push_back({color, caption + " (" + countText(points.size()) + ")"});
  };
  picture.overlay.entries.push_back({kStaticColor, "static, kept"});
  add(content.removedMoving, kTrueRemovalColor, 1.0, "moving, removed");
  add(content.keptMoving, kRemovedColor, 2.0, "moving, left behind");
  add(content.removedStatic, kLostColor, 2.0, "static, lost");
  picture.overlay.title = titleOf("Errors of the map", content.name);
  picture.overlay.subtitle = sizeText(picture.subject.extent);
  inRenderThread([&] { PictureDrawer(options).draw(picture, {{view, file}}); });
}

}  // namespace toss
