// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "LivePlayer.h"
#include "ViewerState.h"

namespace toss {

/// How the window is opened.
struct WindowRequest {
  /// Size of the drawing area [px].
  int width = 1280, height = 720;
  CameraMode camera = CameraMode::Chase;
  /// See ViewerState.
  double speed = 1.0;
  /// If not empty: play to the end as fast as it goes, write what the window shows there, and
  /// close.
  std::filesystem::path screenshot;
};

/// Plays the log in a window until it is closed. Throws UserError where there is no display.
void showWindow(LivePlayer& player, const WindowRequest& request);

}  // namespace toss
