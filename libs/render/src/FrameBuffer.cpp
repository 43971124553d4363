// SPDX-License-Identifier: BSD-3-Clause
#include "FrameBuffer.h"

#include <dlfcn.h>
#include <toss/render/RenderUnavailable.h>

#include <cstdlib>
#include <stdexcept>

namespace toss {
namespace {

/// What MRPT creates and does not free. Looked up in the library that MRPT has loaded, so that
/// building needs no headers of EGL.
struct EglObjects {
  void *display = nullptr, *context = nullptr, *surface = nullptr;

  void destroy() const {
    using MakeCurrent = unsigned (*)(void*, void*, void*, void*);
    using Destroy = unsigned (*)(void*, void*);
    void* const library = ::dlopen("libEGL.so.1", RTLD_LAZY | RTLD_NOLOAD);
    if (!library) return;
    const auto makeCurrent = reinterpret_cast<MakeCurrent>(::dlsym(library, "eglMakeCurrent"));
    const auto destroyContext = reinterpret_cast<Destroy>(::dlsym(library, "eglDestroyContext"));
    const auto destroySurface = reinterpret_cast<Destroy>(::dlsym(library, "eglDestroySurface"));
    if (makeCurrent && destroyContext && destroySurface) {
      makeCurrent(display, nullptr, nullptr, nullptr);
      if (context) destroyContext(display, context);
      if (surface) destroySurface(display, surface);
    }
    ::dlclose(library);
  }
};

}  // namespace

struct FrameBuffer::Renderer : mrpt::opengl::CFBORender {
  using CFBORender::CFBORender;
  EglObjects eglObjects() const { return {m_eglDpy, m_eglContext, m_eglSurf}; }
};

FrameBuffer::FrameBuffer(int width, int height) {
  if (width % 4 != 0 || width <= 0 || height <= 0)
    throw std::logic_error("FrameBuffer: the width must be a multiple of 4");
  // Mesa's software renderer lowers MRPT's mediump shaders to 16-bit floats on processors that have
  // them: depths get coarse, and pictures differ between machines. Without the capability they are
  // exact and the same everywhere.
  ::setenv("GALLIUM_OVERRIDE_CPU_CAPS", "sse4.1", 0);
  try {
    renderer_ =
        std::make_unique<Renderer>(static_cast<unsigned>(width), static_cast<unsigned>(height));
  } catch (const std::exception&) {
    throw RenderUnavailable("pictures", "this machine offers no off-screen drawing through EGL",
                            "install the packages libgl1-mesa-dri and libegl1");
  }
}

FrameBuffer::~FrameBuffer() {
  const EglObjects objects = renderer_->eglObjects();
  // First, while its context is current: it frees textures.
  renderer_.reset();
  objects.destroy();
}

mrpt::opengl::CFBORender& FrameBuffer::renderer() {
  return *renderer_;
}

}  // namespace toss
