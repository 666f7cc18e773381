// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "luxel/viewer/viewer.h"

// The actions of all keys except those of the camera.

namespace luxel {
namespace {

constexpr float zoom_of_key = 0.9f;  // of the distance to what is in the middle

}  // namespace

void Viewer::handle_shortcut(Key key) {
  switch (key) {
    case 'O':
      return ask_open();
    case 'S':
      if (session.light()) ask_save_solution();
      return;
    case 'E':
      if (session.light()) ask_export();
      return;
    case 'Q':
      return close();
    case 'Z':
      return camera.is_shifted() ? redo_light() : undo_light();
    case 'Y':
      return redo_light();
    default:
      return;
  }
}

void Viewer::handle_key(Key key) {
  if (camera.has_control()) return handle_shortcut(key);
  const auto flip = [](bool& choice) { choice = !choice; };
  switch (key) {
    case key::tab:
      toggle_flying();
      return;
    case key::escape:
      if (camera.is_flying()) toggle_flying();
      look.help = look.about = false;
      light_probe.unpin();
      light_probe.clear_line();
      return;
    case key::f1:
      flip(look.help);
      return;
    case key::f11:
      toggle_full_screen();
      return;
    case key::f12:
      save_picture(fmt::format("{}.png", session.title()), screen_.pixels());
      return;
    case key::page_up:
      change_exposure(1);
      return;
    case key::page_down:
      change_exposure(-1);
      return;
    case '=':  // with Shift: +
      camera.zoom(zoom_of_key);
      return;
    case '-':
      camera.zoom(1.0f / zoom_of_key);
      return;
    case 'P':
      flip(look.panel);
      return;
    case 'G':
      flip(look.wires);
      return;
    case 'N':
      flip(look.normals);
      return;
    case 'B':
      flip(look.boxes);
      return;
    case 'R':
      flip(look.rays);
      return;
    case 'C':
      flip(look.solids);
      return;
    case 'X':
      flip(look.automatic_exposure);
      return;
    case 'L':
      look.show = Show::light;
      return;
    case 'I':
      look.show = Show::irradiance;
      return;
    case 'O':
      look.show = static_cast<Show>((static_cast<int>(look.show) + 1) % show_count);
      return;
    case 'T':
      look.tone.op = static_cast<ToneOperator>((static_cast<int>(look.tone.op) + 1) % tone_operators);
      return;
    case ' ':
      toggle_pause();
      return;
    default:
      return;
  }
}

}  // namespace luxel
