// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/opengl/COpenGLScene.h>
#include <mrpt/opengl/CPointCloudColoured.h>
#include <mrpt/opengl/CSetOfLines.h>
#include <mrpt/opengl/CSetOfObjects.h>

#include "LiveFrame.h"

namespace toss {

/// The frame as objects of an MRPT scene. All calls need the scene's lock.
class WindowScene {
 public:
  /// Puts its objects into `scene`, which is kept.
  explicit WindowScene(const mrpt::opengl::COpenGLScene::Ptr& scene);

  /// Shows the frame.
  void show(const LiveFrame& frame, const LayerChoice& layers);
  /// Map coordinates [m] of the scene's origin: the first position of the sensor.
  const Eigen::Vector3d& origin() const { return origin_; }

 private:
  void showPoints(const LiveFrame& frame, const LayerChoice& layers);
  void showMap(const LiveFrame& frame, const LayerChoice& layers);
  void showTraces(const LiveFrame& frame, const LayerChoice& layers);
  void showTrajectory(const LiveFrame& frame, const LayerChoice& layers);

  mrpt::opengl::COpenGLScene::Ptr scene_;
  mrpt::opengl::CSetOfObjects::Ptr points_, map_, traces_;
  mrpt::opengl::CSetOfLines::Ptr trajectory_;
  std::shared_ptr<const std::vector<MapPoint>> shownMap_;
  bool placed_ = false;
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
};

}  // namespace toss
