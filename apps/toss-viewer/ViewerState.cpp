// SPDX-License-Identifier: BSD-3-Clause
#include "ViewerState.h"

#include <algorithm>
#include <cctype>

namespace toss {
namespace {

constexpr int kEscape = 27;
constexpr double kSlowest = 0.125, kFastest = 16.0;

void setSpeed(double& speed, double factor) {
  if (speed == 0.0)
    speed = factor < 1.0 ? kFastest : 0.0;
  else
    speed = speed * factor > kFastest ? 0.0 : std::max(kSlowest, speed * factor);
}

}  // namespace

void ViewerState::press(int key) {
  if (key >= '1' && key < '1' + kLayerCount) {
    bool& shown = layers.shown[key - '1'];
    shown = !shown;
    return;
  }
  switch (std::tolower(key)) {
    case ' ':
      paused = !paused;
      break;
    case 'n':
      paused = step = true;
      break;
    case '+':
    case '=':
      setSpeed(speed, 2.0);
      break;
    case '-':
      setSpeed(speed, 0.5);
      break;
    case 'c':
      camera = static_cast<CameraMode>((static_cast<int>(camera) + 1) % 4);
      break;
    case ']':
    case '[':
      layers.pointSize = std::clamp(layers.pointSize + (key == ']' ? 1.0 : -1.0), 1.0, 12.0);
      break;
    case 's':
      screenshot = true;
      break;
    case 'h':
      help = !help;
      break;
    case 'q':
    case kEscape:
      quit = true;
      break;
    default:
      break;
  }
}

const std::vector<std::string>& helpLines() {
  static const std::vector<std::string> lines = {
      "space  pause, go on",
      "n      next scan, then pause",
      "+ -    faster, slower",
      "c      camera: chase, top, follow, free",
      "[ ]    smaller, larger points",
      "1      ground",
      "2      what stands",
      "3      what moves",
      "4      boxes with number, speed and arrow",
      "5      map",
      "6      trajectory",
      "s      screenshot into the working directory",
      "h      this help",
      "q      quit",
      "mouse  left turns, right moves, wheel zooms (camera follow or free)"};
  return lines;
}

const char* nameOf(CameraMode mode) {
  constexpr const char* kNames[] = {"chase", "top", "follow", "free"};
  return kNames[static_cast<int>(mode)];
}

}  // namespace toss
