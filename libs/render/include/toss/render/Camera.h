// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/render/Extent.h>

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace toss {

/// Where a picture is taken from.
enum class View {
  Top,    ///< straight down without perspective, x to the right and y up
  Chase,  ///< from behind and above, along the direction of travel, on the middle of the map
  Corner  ///< from above a corner, the whole map in the picture
};

/// A place in a picture.
struct PicturePoint {
  /// Right and down from the upper left corner of the picture [px].
  double u = 0.0, v = 0.0;
  /// Distance along the direction of sight [m].
  double depth = 0.0;
};

/// Part of a picture [px] that is kept free for the map; the rest carries title and legend.
struct PictureFrame {
  double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;
};

/// The camera of MRPT's scenes: looks at `target` from a direction and a distance.
struct Camera {
  /// Vertical field of view of perspective cameras [rad].
  static constexpr double kFieldOfView = 30.0 * 3.14159265358979323846 / 180.0;

  /// What is looked at [m, map frame].
  Eigen::Vector3d target = Eigen::Vector3d::Zero();
  /// Direction from the target to the camera [rad]: about the vertical from x, and above the
  /// horizontal plane.
  double azimuth = 0.0, elevation = 0.0;
  /// From the target to the camera [m]; without perspective the picture shows half as many metres
  /// from top to bottom.
  double distance = 1.0;
  bool perspective = true;
  /// Size of the picture [px].
  int width = 0, height = 0;

  Eigen::Vector3d position() const;
  /// Unit vectors of the picture, map frame: to the right, up, and along the direction of sight.
  Eigen::Vector3d right() const;
  Eigen::Vector3d up() const;
  Eigen::Vector3d forward() const;
  /// Size of one metre [px] across the direction of sight, at that depth [m].
  double pixelsPerMetre(double depth) const;
  /// Where a point [m, map frame] is seen; nothing for points behind a perspective camera.
  std::optional<PicturePoint> project(const Eigen::Vector3d& point) const;
};

/// What a picture is to show.
struct ViewSubject {
  Extent extent;
  /// All of the map: outlineOf(), or the extent's corners.
  std::vector<Eigen::Vector3d> outline;
  /// What View::Chase looks at [m, map frame], and the direction of travel there [rad].
  Eigen::Vector3d focus = Eigen::Vector3d::Zero();
  double heading = 0.0;
};

/// A camera that shows all of the map inside `frame` of a picture of width x height [px], as large
/// as it gets; View::Chase comes nearer and shows about half of it, around the focus.
Camera frameView(View view, const ViewSubject& subject, int width, int height,
                 const PictureFrame& frame);

}  // namespace toss
