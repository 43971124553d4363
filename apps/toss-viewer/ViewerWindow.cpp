// SPDX-License-Identifier: BSD-3-Clause
#include "ViewerWindow.h"

#include <chrono>
#include <cstdio>
#include <iostream>
#include <thread>

#include "FramePainter.h"
#include "KeyQueue.h"
#include "PictureFile.h"
#include "QuietWindow.h"
#include "TraceShape.h"
#include "WindowScene.h"

namespace toss {
namespace {

using Clock = std::chrono::steady_clock;
constexpr double kDegrees = 180.0 / 3.14159265358979323846;

/// The scene, locked as long as it lives.
class SceneLock {
 public:
  explicit SceneLock(mrpt::gui::CDisplayWindow3D& window)
      : window_(window), scene_(window.get3DSceneAndLock()) {}
  ~SceneLock() { window_.unlockAccess3DScene(); }
  SceneLock(const SceneLock&) = delete;
  SceneLock& operator=(const SceneLock&) = delete;
  const mrpt::opengl::COpenGLScene::Ptr& scene() const { return scene_; }

 private:
  mrpt::gui::CDisplayWindow3D& window_;
  mrpt::opengl::COpenGLScene::Ptr& scene_;
};

class Viewer {
 public:
  Viewer(LivePlayer& player, const WindowRequest& request)
      : player_(player),
        request_(request),
        window_("TOSS - " + player.name(), request.width, request.height),
        keys_(window_),
        scene_(SceneLock(window_).scene()) {
    state_.camera = request.camera;
    state_.speed = request.screenshot.empty() ? request.speed : 0.0;
  }

  void run() {
    due_ = Clock::now();
    while (window_.isOpen() && !state_.quit) {
      takeKeys();
      const bool playing = !ended_ && (state_.step || (!state_.paused && Clock::now() >= due_));
      if (playing)
        advance();
      else
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
      if (state_.screenshot && frame_.map) saveScreenshot(nextScreenshotName());
      if (!ended_ || request_.screenshot.empty()) continue;
      saveScreenshot(request_.screenshot);
      return;
    }
  }

 private:
  void takeKeys() {
    const std::vector<int> keys = keys_.take();
    for (const int key : keys) state_.press(key);
    if (!keys.empty() && frame_.map) refresh();
  }

  void advance() {
    const double before = frame_.time;
    state_.step = false;
    ended_ = !player_.next(frame_);
    if (ended_) {
      refresh();
      return;
    }
    const double wait = state_.speed > 0.0 ? (frame_.time - before) / state_.speed : 0.0;
    due_ = std::max(
        due_ + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(wait)),
        Clock::now());
    moveCamera();
    refresh();
  }

  void refresh() {
    {
      const SceneLock lock(window_);
      scene_.show(frame_, state_.layers);
      writeTexts(*lock.scene()->getViewport());
    }
    window_.forceRepaint();
  }

  /// Where the user or the mode has put the camera, map frame.
  Camera windowCamera() const {
    Camera camera;
    Eigen::Vector3f target;
    window_.getCameraPointingToPoint(target.x(), target.y(), target.z());
    camera.target = frame_.trajectory.front() + target.cast<double>();
    camera.azimuth = static_cast<double>(window_.getCameraAzimuthDeg()) / kDegrees;
    camera.elevation = static_cast<double>(window_.getCameraElevationDeg()) / kDegrees;
    camera.distance = static_cast<double>(window_.getCameraZoom());
    camera.perspective = window_.isCameraProjective();
    camera.width = request_.width;
    camera.height = request_.height;
    return camera;
  }

  void moveCamera() {
    Camera camera = windowCamera();
    camera = guide_.next(state_.camera, frame_.mapFromSensor, camera);
    if (state_.camera == CameraMode::Free) return;
    const Eigen::Vector3f target = (camera.target - frame_.trajectory.front()).cast<float>();
    window_.setCameraPointingToPoint(target.x(), target.y(), target.z());
    if (state_.camera == CameraMode::Follow) return;
    window_.setCameraProjective(camera.perspective);
    window_.setCameraAzimuthDeg(static_cast<float>(camera.azimuth * kDegrees));
    window_.setCameraElevationDeg(static_cast<float>(camera.elevation * kDegrees));
    window_.setCameraZoom(static_cast<float>(camera.distance));
  }

  void writeTexts(mrpt::opengl::COpenGLViewport& viewport) const {
    viewport.clearTextMessages();
    mrpt::opengl::TFontParams font;
    font.vfont_name = "mono";
    font.vfont_scale = 12.0f;
    font.draw_shadow = true;
    viewport.addTextMessage(10, -24, statusOf(frame_), 0, font);
    char speed[32] = "";
    if (state_.speed > 0.0) std::snprintf(speed, sizeof speed, "x%g", state_.speed);
    const std::string mode = std::string(state_.speed > 0.0 ? speed : "as fast as it goes") +
                             (ended_          ? ", at the end"
                              : state_.paused ? ", paused"
                                              : "") +
                             ", camera " + nameOf(state_.camera) + "   h: help";
    viewport.addTextMessage(10, 10, mode, 1, font);
    if (!state_.help) return;
    const auto& lines = helpLines();
    for (std::size_t i = 0; i < lines.size(); ++i)
      viewport.addTextMessage(30, -60 - 22 * static_cast<int>(i), lines[i], 2 + i, font);
  }

  std::filesystem::path nextScreenshotName() {
    state_.screenshot = false;
    char name[48];
    std::filesystem::path file;
    for (int number = 0; file.empty() || std::filesystem::exists(file); ++number) {
      std::snprintf(name, sizeof name, "toss-viewer-%03d.png", number);
      file = name;
    }
    return file;
  }

  /// Drawn off-screen with the window's camera: of the window itself MRPT gives a black picture
  /// where the display has no graphics card.
  void saveScreenshot(const std::filesystem::path& file) {
    const Camera camera = windowCamera();
    inRenderThread([&] {
      FramePainter painter(request_.width, request_.height);
      writePicture(file, painter.paint(frame_, state_.layers, camera, player_.name()));
    });
    std::cerr << "toss-viewer: wrote " << file.string() << "\n";
  }

  LivePlayer& player_;
  const WindowRequest& request_;
  QuietWindow window_;
  KeyQueue keys_;
  WindowScene scene_;
  ViewerState state_;
  CameraGuide guide_;
  LiveFrame frame_;
  bool ended_ = false;
  Clock::time_point due_;
};

}  // namespace

void showWindow(LivePlayer& player, const WindowRequest& request) {
  // As for pictures drawn off-screen: exact depths with Mesa's software renderer.
  ::setenv("GALLIUM_OVERRIDE_CPU_CAPS", "sse4.1", 0);
  Viewer(player, request).run();
}

}  // namespace toss
