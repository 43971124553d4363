// SPDX-License-Identifier: BSD-3-Clause
#include "QuietWindow.h"

#include <toss/geometry/Error.h>

#include <chrono>
#include <cstdlib>
#include <future>
#include <memory>
#include <thread>

namespace toss {
namespace {

constexpr const char* kRemedy = "use --record FILE.mp4, which needs none, or xvfb-run";

std::string displayName() {
  const char* display = std::getenv("DISPLAY");
  if (display == nullptr || *display == '\0')
    throw UserError("DISPLAY", "there is no display to open a window on", kRemedy);
  return display;
}

}  // namespace

QuietWindow::QuietWindow(const std::string& title, int width, int height)
    : CDisplayWindow3D((displayName(), title), static_cast<unsigned>(width),
                       static_cast<unsigned>(height)) {
  if (!wait_for_GL_context(20.0) || !isOpen())
    throw UserError("DISPLAY " + displayName(), "no window can be opened there", kRemedy);
}

QuietWindow::~QuietWindow() {
  destroyWxWindow();
  for (int round = 0; round < 5; ++round) waitForDrawingThread();
}

void QuietWindow::waitForDrawingThread() {
  const auto done = std::make_shared<std::promise<void>>();
  sendFunctionToRunOnGUIThread([done] { done->set_value(); });
  done->get_future().wait_for(std::chrono::seconds(1));
  std::this_thread::sleep_for(std::chrono::milliseconds(40));
}

}  // namespace toss
