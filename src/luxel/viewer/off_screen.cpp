// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <string_view>

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include "luxel/core/error.h"
#include "luxel/viewer/screen.h"

namespace luxel {
namespace {

bool has_extension(const char* list, std::string_view name) {
  return list != nullptr && std::string_view(list).find(name) != std::string_view::npos;
}

// A display without a screen, which Mesa and NVIDIA provide.
EGLDisplay surfaceless_display() {
  const char* client = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  const auto open = [](EGLenum platform, void* native) {
    const auto display = eglGetPlatformDisplayEXT(platform, native, nullptr);
    return display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr) ? display : EGL_NO_DISPLAY;
  };
  auto display = EGL_NO_DISPLAY;
  if (has_extension(client, "EGL_MESA_platform_surfaceless"))
    display = open(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY);
  if (display == EGL_NO_DISPLAY && has_extension(client, "EGL_EXT_platform_device") &&
      has_extension(client, "EGL_EXT_device_enumeration")) {
    EGLDeviceEXT device = nullptr;
    EGLint devices = 0;
    if (eglQueryDevicesEXT(1, &device, &devices) && devices > 0)
      display = open(EGL_PLATFORM_DEVICE_EXT, device);
  }
  return display;
}

class OffScreen final : public Screen {
 public:
  OffScreen(ScreenSize size, float pixel_ratio, float text_scale)
      : size_(size), ratio_(pixel_ratio), text_scale_(text_scale > 0.0f ? text_scale : pixel_ratio) {
    display_ = surfaceless_display();
    if (display_ == EGL_NO_DISPLAY) throw DeviceError("EGL has no display to draw off screen");
    eglBindAPI(EGL_OPENGL_API);
    const EGLint wanted[] = {EGL_CONTEXT_MAJOR_VERSION,
                             3,
                             EGL_CONTEXT_MINOR_VERSION,
                             3,
                             EGL_CONTEXT_OPENGL_PROFILE_MASK,
                             EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                             EGL_NONE};
    context_ = eglCreateContext(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wanted);
    if (context_ == EGL_NO_CONTEXT || !eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_)) {
      eglTerminate(display_);
      throw DeviceError("the graphics driver has no OpenGL 3.3 core context to draw off screen");
    }
  }
  ~OffScreen() override {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);
    eglTerminate(display_);
  }
  OffScreen(const OffScreen&) = delete;
  OffScreen& operator=(const OffScreen&) = delete;

  ScreenSize size() const override { return size_; }
  ScreenSize pixels() const override {
    return {static_cast<int>(std::lround(static_cast<float>(size_.width) * ratio_)),
            static_cast<int>(std::lround(static_cast<float>(size_.height) * ratio_))};
  }
  float text_scale() const override { return text_scale_; }
  std::vector<Event> poll(double) override { return {}; }
  void capture_cursor(bool) override {}
  bool is_shown() const override { return true; }
  void set_size(ScreenSize size) override { size_ = size; }
  void set_full_screen(bool full) override { is_full_ = full; }
  bool is_full_screen() const override { return is_full_; }
  void set_title(const std::string&) override {}
  // A frame ends when it is drawn: its time is measured, and frames do not pile up in the driver.
  void present() override { glFinish(); }
  std::string clipboard() const override { return clipboard_; }
  void set_clipboard(const std::string& text) override { clipboard_ = text; }

 private:
  ScreenSize size_;
  float ratio_, text_scale_;
  bool is_full_ = false;
  std::string clipboard_;
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace

std::unique_ptr<Screen> open_off_screen(ScreenSize size, float pixel_ratio, float text_scale) {
  return std::make_unique<OffScreen>(size, pixel_ratio, text_scale);
}

}  // namespace luxel
