// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/viewer/viewer.h"

// What a person does in the window.

namespace luxel {
namespace {

constexpr double picture_seconds = 0.005;  // of a frame, for tiles of a picture that is to be saved

}  // namespace

void Viewer::handle(const Event& event) {
  unchanged_frames_ = 0;
  gui_.handle(event, !navigator.is_flying());
  switch (event.kind) {
    case Event::Kind::close:
      close();
      return;
    case Event::Kind::drop:
      open(event.text);
      return;
    case Event::Kind::resize:
      navigator.set_screen(screen_.size());
      return;
    case Event::Kind::key:
      if (gui_.wants_keys() && event.down) return;
      if (!navigator.handle(event) && event.down && !event.repeat) handle_key(event.key);
      return;
    case Event::Kind::button:
      // A drag that began on a panel stays there, and one that began on the scene likewise.
      if (event.down) mouse_is_for_panels_ = !navigator.is_flying() && gui_.wants_mouse();
      if (mouse_is_for_panels_) return;
      handle_line(event);
      if (!line) navigator.handle(event);
      return;
    case Event::Kind::move:
      navigator.handle(event);
      if (line) line->second = navigator.aim();
      return;
    case Event::Kind::wheel:
      if (!navigator.is_flying() && gui_.wants_mouse()) return;
      if (!navigator.handle(event))
        look.tone.exposure = std::clamp(look.tone.exposure + 0.25f * event.at.y, -20.0f, 20.0f);
      return;
    default:
      return;
  }
}

void Viewer::toggle_flying() {
  navigator.set_flying(!navigator.is_flying());
  screen_.capture_cursor(navigator.is_flying());
}

void Viewer::handle_key(Key key) {
  const auto flip = [](bool& choice) { choice = !choice; };
  switch (key) {
    case key::tab:
      toggle_flying();
      return;
    case key::escape:
      if (navigator.is_flying()) toggle_flying();
      look.help = false;
      inquiry.unpin();
      inquiry.clear_line();
      return;
    case key::f1:
      flip(look.help);
      return;
    case key::f12:
      save_picture(fmt::format("{}.png", session.title()), screen_.pixels());
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
      look.tone.op = static_cast<ToneOperator>((static_cast<int>(look.tone.op) + 1) % 4);
      return;
    case ' ':
      if (session.has_scene()) session.status().is_paused ? session.live().resume() : session.live().pause();
      return;
    default:
      return;
  }
}

// Shift and drag: a line whose profile is asked for. A click that does not drag pins the probe.
void Viewer::handle_line(const Event& event) {
  if (navigator.is_flying() || event.button != MouseButton::left) return;
  if (event.down && navigator.is_shifted()) {
    line = {navigator.aim(), navigator.aim()};
  } else if (!event.down && line) {
    inquiry.draw_line(navigator.pose(), navigator.space(), navigator.aspect(), line->first, line->second);
    line.reset();
  } else if (!event.down && navigator.is_click()) {
    inquiry.is_pinned() ? inquiry.unpin() : inquiry.pin();
  }
}

void Viewer::relight() {
  if (!session.has_scene() || !session.mesh()) return;
  session.live().relight(lamps.lighting(*session.mesh()->patches));
  lamps_asked = lamps;
}

void Viewer::save_picture(const std::filesystem::path& file, ScreenSize size) {
  if (picture_) return say(fmt::format("{} is still being made", picture_->file().string()));
  try {
    picture_ = std::make_unique<PictureMaker>(file, size, look, viewpoint(), driver_.is_software);
  } catch (const InputError& error) {
    complain(error.what());
  }
}

void Viewer::go_on_with_picture(bool to_the_end) {
  if (!picture_) return;
  if (!picture_->has_begun()) picture_->begin(curve_);
  try {
    if (to_the_end) {
      picture_->finish(painter_);
    } else if (!picture_->go_on(painter_, picture_seconds)) {
      return;
    }
    const auto [width, height] = picture_->size();
    say(fmt::format("{} is written, {} x {} pixels", picture_->file().string(), width, height));
  } catch (const std::exception& error) {
    complain(error.what());
  }
  picture_.reset();
}

void Viewer::compare(const std::filesystem::path& file) {
  if (!session.has_scene()) return;
  compared_with_ = file;
  session.live().compare_with(file);
}

void Viewer::show_bounces(std::optional<int> count) {
  if (!session.has_scene()) return;
  bounces = count;
  session.live().show_bounces(count);
}

void Viewer::save_solution(const std::filesystem::path& file) {
  if (session.has_scene()) session.live().save_solution(file);
}

void Viewer::export_glb(const std::filesystem::path& file) {
  if (session.has_scene()) session.live().export_glb(file, navigator.space().up, look.tone);
}

void Viewer::solve_by(const std::string& method) {
  if (!session.has_scene()) return;
  auto light = session.live().options();
  light.method = method;
  bounces.reset();
  if (lamps != lamps_asked) relight();
  session.live().solve(light);
}

}  // namespace luxel
