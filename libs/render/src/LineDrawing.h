// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/Box.h>
#include <toss/render/Camera.h>
#include <toss/render/Color.h>
#include <toss/render/MapContent.h>

#include <Eigen/Core>
#include <array>
#include <opencv2/core/mat.hpp>
#include <utility>
#include <vector>

namespace toss {

/// Ends of the twelve edges of a box [m, map frame].
std::array<std::pair<Eigen::Vector3d, Eigen::Vector3d>, 12> edgesOf(const Box& box);

/// The boxes of a way that are shown: the first, the last, and between them one whenever the box
/// has moved by three of its lengths or 8 m since the one shown before.
std::vector<Box> shownBoxes(const TrackPath& path);

/// Draws lines over a picture as `camera` sees them; `width` in pixels. Nothing hides them: what
/// they mark is to be found even behind a house.
void drawPolyline(cv::Mat& picture, const Camera& camera,
                  const std::vector<Eigen::Vector3d>& vertices, const Color& color, double width);

/// Draws the path of the trace's centre and its last box. Leaves out traces of fewer than 5 boxes
/// and such as stay within 1.5 m: over a large map they would hide what was removed.
void drawTrack(cv::Mat& picture, const Camera& camera, const TrackPath& path);

}  // namespace toss
