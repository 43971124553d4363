// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/opengl/CFBORender.h>

#include <memory>

namespace toss {

/// MRPT's off-screen frame buffer with what it needs to be correct and to leave nothing behind: its
/// destructor keeps the EGL context, some 100 MB for a large picture.
class FrameBuffer {
 public:
  /// [px], `width` a multiple of 4. Throws RenderUnavailable.
  FrameBuffer(int width, int height);
  ~FrameBuffer();
  FrameBuffer(const FrameBuffer&) = delete;
  FrameBuffer& operator=(const FrameBuffer&) = delete;

  mrpt::opengl::CFBORender& renderer();

 private:
  struct Renderer;
  std::unique_ptr<Renderer> renderer_;
};

}  // namespace toss
