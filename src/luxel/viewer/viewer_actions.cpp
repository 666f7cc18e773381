// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/viewer/viewer.h"

// Actions of the user in the window.

namespace luxel {
namespace {

constexpr double picture_seconds = 0.005;  // per frame, for tiles of a picture that is to be saved

}  // namespace

void Viewer::handle(const Event& event) {
  frames_since_event_ = 0;
  gui_.handle(event, !camera.is_flying());
  switch (event.kind) {
    case Event::Kind::close:
      close();
      return;
    case Event::Kind::drop:
      drop(event.text);
      return;
    case Event::Kind::leave:
      camera.release_keys();
      return;
    case Event::Kind::resize:
      camera.set_screen(screen_.size());
      return;
    case Event::Kind::key:
      if (gui_.wants_keys() && event.down) return;
      if (!camera.handle(event) && event.down && !event.repeat) handle_key(event.key);
      return;
    case Event::Kind::button:
      // A drag that began on a panel stays with the panels, one that began on the scene with the scene.
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
      if (!camera.handle(event)) change_exposure(static_cast<int>(std::lround(event.at.y)));
      return;
    default:
      return;
  }
}

// Shift and drag draws a line for a profile. A click without a drag pins the probe.
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

void Viewer::toggle_flying() {
  camera.set_flying(!camera.is_flying());
  screen_.capture_cursor(camera.is_flying());
}

void Viewer::toggle_full_screen() { screen_.set_full_screen(!screen_.is_full_screen()); }

std::size_t Viewer::file_views() const {
  const auto& mesh = session.mesh();
  return mesh && mesh->scene ? mesh->scene->cameras.size() : 0;
}

void Viewer::go_to_file_view(std::size_t number) {
  camera.glide_to(pose_of(session.mesh()->scene->cameras[number], camera.space()));
}

void Viewer::change_exposure(int steps) {
  look.tone.exposure = std::clamp(look.tone.exposure + 0.25f * static_cast<float>(steps), -20.0f, 20.0f);
}

void Viewer::toggle_pause() {
  if (session.has_scene()) session.status().is_paused ? session->resume() : session->pause();
}

// ---- Lamps and colours ----

// Light that is not stored per lamp group waits for the panel's button, as after a moved slider.
void Viewer::set_light(const LightMixer& mixer) {
  light.mixer = mixer;
  if (session.has_scene() && session.status().can_relight) relight();
}

void Viewer::undo_light() {
  light.history.note(light.mixer);
  if (light.history.can_undo()) set_light(light.history.undo());
}

void Viewer::redo_light() {
  light.history.note(light.mixer);
  if (light.history.can_redo()) set_light(light.history.redo());
}

void Viewer::switch_lamp(std::size_t group) {
  auto mixer = light.mixer;
  auto& factor = mixer.lamps.at(group).factor;
  factor = factor > 0.0f ? 0.0f : 1.0f;
  set_light(mixer);
}

void Viewer::reset_light() {
  if (session.mesh()) set_light(LightMixer(*session.mesh()->patches));
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
