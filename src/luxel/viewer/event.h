// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "luxel/core/vector.h"

namespace luxel {

// Keys by their labels: letters and digits as characters ('A', '7', ' '), all others by these numbers.
using Key = int;
namespace key {
inline constexpr Key escape = 256, enter = 257, tab = 258, backspace = 259, insert = 260, del = 261,
                     right = 262, left = 263, down = 264, up = 265, page_up = 266, page_down = 267,
                     home = 268, end = 269, f1 = 290, f11 = 300, f12 = 301, shift = 340, control = 341,
                     alt = 342;
inline constexpr int count = 349;  // keys are below
}  // namespace key

enum class MouseButton { left, right, middle };

// Input of a user, from a window of the system or a script.
struct Event {
  enum class Kind {
    key,
    text,
    move,
    button,
    wheel,
    resize,
    drop,
    expose,  // the window is visible again and must be drawn
    leave,   // another window gets the keys: pressed ones count as released
    close
  };
  Kind kind = Kind::move;
  Key key = 0;          // key
  bool down = false;    // key, button: pressed, else released
  bool repeat = false;  // key: held down, repeated by the system
  MouseButton button = MouseButton::left;
  Vec2 at = Vec2(0.0f);   // move: the cursor from the top left, in units of Screen::size(); wheel: its turn;
                          // resize: the new size
  std::string text = {};  // text: what was typed, UTF-8; drop: the files' paths, one per line
};

}  // namespace luxel
