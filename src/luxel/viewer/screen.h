// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "luxel/viewer/event.h"

namespace luxel {

struct ScreenSize {
  int width = 1280, height = 800;

  bool operator==(const ScreenSize&) const = default;
  bool empty() const { return width <= 0 || height <= 0; }
};

// Offset of a part of a picture: pixels from the left and from the bottom.
struct PixelOffset {
  int left = 0, bottom = 0;
};

// Display of pictures, with an OpenGL 3.3 core context that is current on the thread that made it: a window
// or memory. All calls from that thread.
class Screen {
 public:
  virtual ~Screen() = default;

  virtual ScreenSize size() const = 0;    // in the cursor's units; empty while minimised
  virtual ScreenSize pixels() const = 0;  // more where pixels are small
  virtual float text_scale() const = 0;   // how much larger text is to be, 1 on an ordinary screen

  // Returns the events since the last call. Waits up to this many seconds for one; 0: does not wait.
  virtual std::vector<Event> poll(double seconds) = 0;
  // While captured the cursor is hidden, and its movement is unlimited.
  virtual void capture_cursor(bool captured) = 0;
  // Returns whether it is visible; pictures of a hidden window need not be made.
  virtual bool is_shown() const = 0;
  virtual void set_size(ScreenSize size) = 0;
  virtual void set_full_screen(bool full) = 0;
  virtual bool is_full_screen() const = 0;
  virtual void set_title(const std::string& title) = 0;
  // Copies the current read framebuffer to the display, and waits for its next refresh.
  virtual void present() = 0;
  virtual std::string clipboard() const = 0;
  virtual void set_clipboard(const std::string& text) = 0;
};

// Both throw DeviceError, one sentence, where the screen is not available: no display, no driver, or no
// OpenGL 3.3. text_scale: as Screen::text_scale(); 0: that of the display.
//
// A window: at most as large as the display has room for, which the size is increased for where pixels are
// small. The display's scale is that of the desktop or GDK_SCALE, whichever is larger.
std::unique_ptr<Screen> open_window(const std::string& title, ScreenSize size, float text_scale = 0.0f);
// pixel_ratio: pixels per unit.
std::unique_ptr<Screen> open_off_screen(ScreenSize size, float pixel_ratio = 1.0f, float text_scale = 0.0f);

// Name and version of the driver, and whether it draws on the processor: then a frame takes milliseconds, and
// fewer frames are better.
struct Driver {
  std::string name, version;
  bool is_software = false;
};
Driver current_driver();

}  // namespace luxel
