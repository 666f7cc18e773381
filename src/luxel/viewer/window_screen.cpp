// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdlib>
#include <utility>

#define GLFW_INCLUDE_NONE  // epoxy brings OpenGL
#include <GLFW/glfw3.h>
#include <epoxy/gl.h>
#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/viewer/screen.h"

namespace luxel {
namespace {

// GLFW's latest error, as the end of a sentence.
std::string complaint() {
  const char* said = nullptr;
  return glfwGetError(&said) == GLFW_NO_ERROR || said == nullptr ? "" : fmt::format(" ({})", said);
}

bool is_version_missing(int code) { return code == GLFW_VERSION_UNAVAILABLE || code == GLFW_API_UNAVAILABLE; }

// The scale set for GTK programs where the desktop gives GLFW none.
float scale_of_environment() {
  const char* text = std::getenv("GDK_SCALE");
  const float scale = text == nullptr ? 1.0f : std::strtof(text, nullptr);
  return scale >= 1.0f && scale <= 8.0f ? scale : 1.0f;
}

struct Place {
  int left = 0, top = 0;
  ScreenSize size;
};

// Place of a hidden window: in the middle of the display, with its frame within the part that is free of
// bars, and no larger than that.
Place place_for(GLFWwindow* window, ScreenSize wanted) {
  auto* const monitor = glfwGetPrimaryMonitor();
  Place room;
  if (monitor == nullptr) return {0, 0, wanted};
  glfwGetMonitorWorkarea(monitor, &room.left, &room.top, &room.size.width, &room.size.height);
  int left = 0, top = 0, right = 0, bottom = 0;
  glfwGetWindowFrameSize(window, &left, &top, &right, &bottom);
  const ScreenSize inner{room.size.width - left - right, room.size.height - top - bottom};
  if (inner.empty()) return {0, 0, wanted};
  const ScreenSize size{std::min(wanted.width, inner.width), std::min(wanted.height, inner.height)};
  return {room.left + left + (inner.width - size.width) / 2,
          room.top + top + (inner.height - size.height) / 2, size};
}

GLFWwindow* make_window(const std::string& title, ScreenSize size) {
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  // Depth, samples and the sRGB curve are those of Luxel's own framebuffer, see DrawnFrame: the same
  // everywhere.
  glfwWindowHint(GLFW_DEPTH_BITS, 0);
  glfwWindowHint(GLFW_STENCIL_BITS, 0);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);  // until it has its place
  auto* const window = glfwCreateWindow(size.width, size.height, title.c_str(), nullptr, nullptr);
  if (window != nullptr) return window;
  const char* said = nullptr;
  const int code = glfwGetError(&said);
  glfwTerminate();
  if (is_version_missing(code))
    throw DeviceError(fmt::format("this graphics driver has no OpenGL 3.3, which the window needs ({})",
                                  said == nullptr ? "no more is known" : said));
  throw DeviceError(
      fmt::format("no window could be opened ({})", said == nullptr ? "no reason given" : said));
}

class WindowScreen final : public Screen {
 public:
  WindowScreen(const std::string& title, ScreenSize size, float text_scale) : text_scale_(text_scale) {
    if (glfwInit() != GLFW_TRUE) throw DeviceError(fmt::format("there is no display{}", complaint()));
    window_ = make_window(title, size);
    show();
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(1);
    glfwSetWindowUserPointer(window_, this);
    listen();
  }
  ~WindowScreen() override {
    glfwDestroyWindow(window_);
    glfwTerminate();
  }
  WindowScreen(const WindowScreen&) = delete;
  WindowScreen& operator=(const WindowScreen&) = delete;

  ScreenSize size() const override {
    ScreenSize size;
    glfwGetWindowSize(window_, &size.width, &size.height);
    return pixels().empty() ? ScreenSize{0, 0} : size;
  }
  ScreenSize pixels() const override {
    ScreenSize pixels;
    glfwGetFramebufferSize(window_, &pixels.width, &pixels.height);
    return pixels;
  }
  float text_scale() const override {
    if (text_scale_ > 0.0f) return text_scale_;
    float x = 1.0f, y = 1.0f;
    glfwGetWindowContentScale(window_, &x, &y);
    return std::max(x, scale_of_environment());
  }
  std::vector<Event> poll(double seconds) override {
    if (seconds > 0.0) {
      glfwWaitEventsTimeout(seconds);
    } else {
      glfwPollEvents();
    }
    return std::exchange(events_, {});
  }
  void capture_cursor(bool captured) override {
    glfwSetInputMode(window_, GLFW_CURSOR, captured ? GLFW_CURSOR_DISABLED : GLFW_CURSOR_NORMAL);
    if (captured && glfwRawMouseMotionSupported())
      glfwSetInputMode(window_, GLFW_RAW_MOUSE_MOTION, GLFW_TRUE);
  }
  bool is_shown() const override { return glfwGetWindowAttrib(window_, GLFW_ICONIFIED) == GLFW_FALSE; }
  void set_size(ScreenSize size) override { glfwSetWindowSize(window_, size.width, size.height); }
  void set_full_screen(bool full) override;
  bool is_full_screen() const override { return glfwGetWindowMonitor(window_) != nullptr; }
  void set_title(const std::string& title) override { glfwSetWindowTitle(window_, title.c_str()); }
  void present() override {
    const auto size = pixels();
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glDisable(GL_FRAMEBUFFER_SRGB);  // the codes are sRGB already
    glBlitFramebuffer(0, 0, size.width, size.height, 0, 0, size.width, size.height, GL_COLOR_BUFFER_BIT,
                      GL_NEAREST);
    glfwSwapBuffers(window_);
  }
  std::string clipboard() const override {
    const char* text = glfwGetClipboardString(window_);
    return text == nullptr ? "" : text;
  }
  void set_clipboard(const std::string& text) override { glfwSetClipboardString(window_, text.c_str()); }

 private:
  static WindowScreen& of(GLFWwindow* window) {
    return *static_cast<WindowScreen*>(glfwGetWindowUserPointer(window));
  }
  static void add(GLFWwindow* window, Event event) { of(window).events_.push_back(std::move(event)); }
  void show();
  void listen();
  void listen_to_mouse();

  float text_scale_;  // 0: that of the display
  GLFWwindow* window_ = nullptr;
  Place before_;  // it was full screen
  std::vector<Event> events_;
};

void WindowScreen::show() {
  ScreenSize wanted;
  glfwGetWindowSize(window_, &wanted.width, &wanted.height);  // as GLFW has scaled it to the display
  float scale = 1.0f, y = 1.0f;
  glfwGetWindowContentScale(window_, &scale, &y);
  const float more = std::max(1.0f, scale_of_environment() / scale);
  wanted = {static_cast<int>(static_cast<float>(wanted.width) * more),
            static_cast<int>(static_cast<float>(wanted.height) * more)};
  const auto place = place_for(window_, wanted);
  glfwSetWindowSize(window_, place.size.width, place.size.height);
  glfwSetWindowPos(window_, place.left, place.top);
  glfwSetWindowSizeLimits(window_, 320, 240, GLFW_DONT_CARE, GLFW_DONT_CARE);
  glfwShowWindow(window_);
}

void WindowScreen::set_full_screen(bool full) {
  if (full == is_full_screen()) return;
  if (!full) {
    glfwSetWindowMonitor(window_, nullptr, before_.left, before_.top, before_.size.width, before_.size.height,
                         GLFW_DONT_CARE);
    return;
  }
  auto* const monitor = glfwGetPrimaryMonitor();
  const auto* mode = monitor == nullptr ? nullptr : glfwGetVideoMode(monitor);
  if (mode == nullptr) return;
  glfwGetWindowPos(window_, &before_.left, &before_.top);
  glfwGetWindowSize(window_, &before_.size.width, &before_.size.height);
  glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

// Luxel's keys are GLFW's, except that left and right modifiers are one.
Key key_of(int code) {
  switch (code) {
    case GLFW_KEY_RIGHT_SHIFT:
      return key::shift;
    case GLFW_KEY_RIGHT_CONTROL:
      return key::control;
    case GLFW_KEY_RIGHT_ALT:
      return key::alt;
    case GLFW_KEY_KP_ENTER:
      return key::enter;
    default:
      return code >= 0 && code < key::count ? code : 0;
  }
}

std::string utf8(unsigned int code) {
  const auto tail = [&](unsigned int shift) { return static_cast<char>(0x80u | (code >> shift & 0x3fu)); };
  if (code < 0x80u) return {static_cast<char>(code)};
  if (code < 0x800u) return {static_cast<char>(0xc0u | code >> 6u), tail(0)};
  if (code < 0x10000u) return {static_cast<char>(0xe0u | code >> 12u), tail(6), tail(0)};
  return {static_cast<char>(0xf0u | code >> 18u), tail(12), tail(6), tail(0)};
}

void WindowScreen::listen() {
  glfwSetKeyCallback(window_, [](GLFWwindow* window, int code, int, int action, int) {
    add(window, {.kind = Event::Kind::key,
                 .key = key_of(code),
                 .down = action != GLFW_RELEASE,
                 .repeat = action == GLFW_REPEAT});
  });
  glfwSetCharCallback(window_, [](GLFWwindow* window, unsigned int code) {
    add(window, {.kind = Event::Kind::text, .text = utf8(code)});
  });
  glfwSetDropCallback(window_, [](GLFWwindow* window, int count, const char** paths) {
    std::string all;
    for (int i = 0; i < count; ++i) all += fmt::format("{}\n", paths[i]);
    add(window, {.kind = Event::Kind::drop, .text = std::move(all)});
  });
  glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* window, int width, int height) {
    add(window, {.kind = Event::Kind::resize, .at = Vec2(width, height)});
  });
  // The picture may be lost, so it is drawn again.
  glfwSetWindowRefreshCallback(window_,
                               [](GLFWwindow* window) { add(window, {.kind = Event::Kind::expose}); });
  glfwSetWindowFocusCallback(window_, [](GLFWwindow* window, int has_focus) {
    add(window, {.kind = has_focus ? Event::Kind::expose : Event::Kind::leave});
  });
  glfwSetWindowCloseCallback(window_, [](GLFWwindow* window) { add(window, {.kind = Event::Kind::close}); });
  listen_to_mouse();
}

void WindowScreen::listen_to_mouse() {
  glfwSetCursorPosCallback(window_, [](GLFWwindow* window, double x, double y) {
    add(window, {.kind = Event::Kind::move, .at = Vec2(x, y)});
  });
  glfwSetScrollCallback(window_, [](GLFWwindow* window, double x, double y) {
    add(window, {.kind = Event::Kind::wheel, .at = Vec2(x, y)});
  });
  glfwSetMouseButtonCallback(window_, [](GLFWwindow* window, int button, int action, int) {
    if (button > GLFW_MOUSE_BUTTON_MIDDLE) return;
    const auto which = button == GLFW_MOUSE_BUTTON_LEFT    ? MouseButton::left
                       : button == GLFW_MOUSE_BUTTON_RIGHT ? MouseButton::right
                                                           : MouseButton::middle;
    add(window, {.kind = Event::Kind::button, .down = action == GLFW_PRESS, .button = which});
  });
}

}  // namespace

std::unique_ptr<Screen> open_window(const std::string& title, ScreenSize size, float text_scale) {
  return std::make_unique<WindowScreen>(title, size, text_scale);
}

}  // namespace luxel
