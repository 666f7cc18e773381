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
  renderer_.note_event();
  gui_.handle(event, !camera.is_flying());
  switch (event.kind) {
    case Event::Kind::close:
      close();
      return;
    case Event::Kind::drop:
      open(event.text);
      return;
    case Event::Kind::resize:
      camera.set_screen(screen_.size());
      return;
    case Event::Kind::key:
      if (gui_.wants_keys() && event.down) return;
      if (!camera.handle(event) && event.down && !event.repeat) handle_key(event.key);
      return;
    case Event::Kind::button:
      // A drag that began on a panel stays there, and one that began on the scene likewise.
      if (event.down) mouse_is_for_panels_ = !camera.is_flying() && gui_.wants_mouse();
      if (mouse_is_for_panels_) return;
      handle_line(event);
      if (!line) camera.handle(event);
      return;
    case Event::Kind::move:
      camera.handle(event);
      if (line) line->second = camera.aim();
      return;
    case Event::Kind::wheel:
      if (!camera.is_flying() && gui_.wants_mouse()) return;
      if (!camera.handle(event))
        look.tone.exposure = std::clamp(look.tone.exposure + 0.25f * event.at.y, -20.0f, 20.0f);
      return;
    default:
      return;
  }
}

void Viewer::toggle_flying() {
  camera.set_flying(!camera.is_flying());
  screen_.capture_cursor(camera.is_flying());
}

void Viewer::handle_key(Key key) {
  const auto flip = [](bool& choice) { choice = !choice; };
  switch (key) {
    case key::tab:
      toggle_flying();
      return;
    case key::escape:
      if (camera.is_flying()) toggle_flying();
      look.help = false;
      light_probe.unpin();
      light_probe.clear_line();
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
      look.tone.op = static_cast<ToneOperator>((static_cast<int>(look.tone.op) + 1) % tone_operators);
      return;
    case ' ':
      if (session.has_scene()) session.status().is_paused ? session->resume() : session->pause();
      return;
    default:
      return;
  }
}

// Shift and drag: a line whose profile is asked for. A click that does not drag pins the probe.
void Viewer::handle_line(const Event& event) {
  if (camera.is_flying() || event.button != MouseButton::left) return;
  if (event.down && camera.is_shifted()) {
    line = {camera.aim(), camera.aim()};
  } else if (!event.down && line) {
    light_probe.draw_line(camera.pose(), camera.space(), camera.aspect(), line->first, line->second);
    line.reset();
  } else if (!event.down && camera.is_click()) {
    light_probe.is_pinned() ? light_probe.unpin() : light_probe.pin();
  }
}

void Viewer::relight() {
  if (!session.has_scene() || !session.mesh()) return;
  session->relight(light.mixer.lighting(*session.mesh()->patches));
  light.sent = light.mixer;
}

void Viewer::save_picture(const std::filesystem::path& file, ScreenSize size) {
  if (picture_) return notices.say(fmt::format("{} is still being made", picture_->file().string()));
  try {
    picture_ = std::make_unique<PictureMaker>(file, size, look, viewpoint(), renderer_.is_software());
  } catch (const InputError& error) {
    notices.complain(error.what());
  }
}

void Viewer::continue_picture(bool to_the_end) {
  if (!picture_) return;
  if (!picture_->has_begun()) picture_->begin(curve_);
  try {
    if (to_the_end) {
      picture_->finish(renderer_.painter());
    } else if (!picture_->go_on(renderer_.painter(), picture_seconds)) {
      return;
    }
    const auto [width, height] = picture_->size();
    notices.say(fmt::format("{} is written, {} x {} pixels", picture_->file().string(), width, height));
  } catch (const std::exception& error) {
    notices.complain(error.what());
  }
  picture_.reset();
}

void Viewer::compare(const std::filesystem::path& file) {
  if (!session.has_scene()) return;
  queries.compared_with = file;
  session->compare_with(file);
}

void Viewer::show_bounces(std::optional<int> count) {
  if (!session.has_scene()) return;
  light.bounces = count;
  session->show_bounces(count);
}

void Viewer::save_solution(const std::filesystem::path& file) {
  if (session.has_scene()) session->save_solution(file);
}

void Viewer::export_glb(const std::filesystem::path& file) {
  if (session.has_scene()) session->export_glb(file, camera.space().up, look.tone);
}

void Viewer::solve_by(Method method) {
  if (!session.has_scene()) return;
  auto options = *session.snapshot().options;
  options.method = method;
  light.bounces.reset();
  if (light.mixer != light.sent) relight();
  session->solve(options);
}

}  // namespace luxel
