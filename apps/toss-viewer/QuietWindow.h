// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/gui/CDisplayWindow3D.h>

#include <string>

namespace toss {

/// MRPT's window, closed so that its drawing thread has let go of it before it is destroyed: that
/// of MRPT 2.5.8 may draw once more into memory that is free by then, and crash.
class QuietWindow : public mrpt::gui::CDisplayWindow3D {
 public:
  /// Size of the drawing area [px]. Throws UserError where there is no display.
  QuietWindow(const std::string& title, int width, int height);
  ~QuietWindow() override;

 private:
  /// Waits until the drawing thread has been idle; at most a second.
  void waitForDrawingThread();
};

}  // namespace toss
