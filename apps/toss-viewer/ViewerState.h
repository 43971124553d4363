// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "CameraMode.h"
#include "LiveFrame.h"

namespace toss {

/// What the user has asked for by keys.
struct ViewerState {
  bool paused = false, help = false, quit = false;
  /// Asked for once; whoever does it takes the flag back.
  bool step = false, screenshot = false;
  /// Times the speed of the log; 0 = as fast as it goes.
  double speed = 1.0;
  CameraMode camera = CameraMode::Chase;
  LayerChoice layers;

  /// Does what the key stands for; unknown keys do nothing.
  void press(int key);
};

/// What is written over the scene when help is on, a line each: every key and what it does.
const std::vector<std::string>& helpLines();
/// "chase", "top", "follow" or "free".
const char* nameOf(CameraMode mode);

}  // namespace toss
