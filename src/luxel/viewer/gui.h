// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/viewer/event.h"
#include "luxel/viewer/screen.h"

namespace luxel {

// Dear ImGui, fed with our own events, so that a script and a person press the same buttons. One at a time.
// Needs the screen's context, which it draws with.
class Gui {
 public:
  explicit Gui(Screen& screen);
  ~Gui();
  Gui(const Gui&) = delete;
  Gui& operator=(const Gui&) = delete;

  // free_cursor: false while the mouse looks around; then the panels do not receive it.
  void handle(const Event& event, bool free_cursor);
  // Panels are declared between these two calls.
  void begin(double seconds);
  void draw();

  // Returns whether the last event of its kind is for a panel, as the last frame had them.
  bool wants_mouse() const;
  bool wants_keys() const;
  bool is_typing() const;   // a cursor blinks in a line of text
  bool is_editing() const;  // a value is being changed
  bool is_pressed() const;  // a button of the mouse is held

 private:
  void set_scale(float pixels, float units);
  bool has_popup() const;  // a menu or a dialog is open

  Screen& screen_;
  float pixels_ = 0.0f, units_ = 0.0f;  // see set_scale()
  bool down_[3] = {};                   // mouse buttons
  bool clicked_[3] = {};                // since the last frame: seen for one frame though released in it
};

}  // namespace luxel
