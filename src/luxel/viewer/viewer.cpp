// SPDX-License-Identifier: Apache-2.0
#include "luxel/viewer/viewer.h"

#include <utility>

#include <fmt/format.h>

#include "luxel/viewer/panels.h"

namespace luxel {

Viewer::Viewer(Screen& screen, const WindowSettings& its_settings)
    : session(its_settings.live),
      camera([this](float x, float y) -> std::optional<Vec3> {
        if (!session.mesh() || !session.mesh()->tracer) return std::nullopt;
        const auto seen = sight(camera.pose(), camera.space(), camera.aspect(), x, y);
        const auto hit = session.mesh()->tracer->nearest({seen.origin, seen.direction});
        if (!hit) return std::nullopt;
        return seen.origin + hit.distance * seen.direction;
      }),
      settings(its_settings),
      screen_(screen),
      renderer_(screen),
      gui_(screen) {
  look.tone = settings.tone;
  camera.set_screen(screen.size());
  if (!settings.file.empty()) open(settings.file);
}

// ---- A scene ----

void Viewer::begin_scene() {
  if (picture_ && !picture_->is_drawn()) {
    notices.complain(fmt::format("{} is not made: another scene was opened", picture_->file().string()));
    picture_.reset();
  }
  scene_ = session.number();
  light = {};
  queries = {};
  notices.begin_session();
  home_.forget();
  exposure_.forget();
  light_probe.forget();
  overlays.forget();
  screen_.set_title(fmt::format("{} - Luxel", session.title()));
  if (settings.compare && scene_ == 1) compare(*settings.compare);
}

void Viewer::update(double seconds) {
  session.update();
  for (auto& error : session.take_errors()) notices.complain(std::move(error));
  if (session.number() != scene_) begin_scene();
  if (!session.has_scene()) return;
  notices.say_new(session.status().messages);
  if (!session.mesh()) return;
  // The patches that are lit come after those of the grey preview.
  if (const auto& patches = session.mesh()->patches; patches != light.patches) {
    light.patches = patches;
    light.mixer = light.sent = LightMixer(*patches);
  }
  home_.update(session, settings, camera);
  update_view(seconds);
}

// What follows from where one looks, and from newer light.
void Viewer::update_view(double seconds) {
  const auto& mesh = session.mesh();
  const auto& newest = session.light();
  const float aspect = camera.aspect();
  light_probe.look_at(*mesh, newest.get(), camera.pose(), camera.space(), aspect, camera.aim());
  light_probe.update_profile(*mesh, newest.get());
  if (look.diagnostics && !queries.diagnostics) {
    if (!queries.has_requested_diagnostics) session->request_diagnostics();
    queries.has_requested_diagnostics = true;
    queries.diagnostics = session.snapshot().diagnostics;
  }
  // What a picture is being made of stays as it is, and what is seen with it.
  if (is_drawing_picture()) return;
  const auto& seen = seen_look();
  auto& painter = renderer_.painter();
  if (overlays.update(seen, mesh, newest, light_probe, queries.diagnostics))
    painter.set_marks(overlays.marks());
  curve_ = exposure_.curve(seen.tone, seen.automatic_exposure, newest.get(),
                           {camera.pose(), camera.space(), aspect}, seconds);
  painter.update(scene_, mesh, newest, seen, session.snapshot().difference);
}

// ---- A frame ----

Viewpoint Viewer::viewpoint() const {
  return {camera.pose(), camera.space(), camera.box(), curve_, camera.aspect()};
}

bool Viewer::is_at_rest() const {
  return renderer_.is_uploaded() && !picture_ && exposure_.is_settled() && !camera.is_moving() &&
         !session.is_busy();
}

void Viewer::draw_scene(bool fine) {
  const auto& newest = session.light();
  renderer_.draw({scene_, camera.pose(), look, curve_.scale, newest ? newest->number : 0, overlays.version()},
                 seen_look(), viewpoint(), line.has_value(), fine);
}

void Viewer::frame(double seconds, bool fine) {
  notices.advance(seconds);
  camera.advance(seconds);
  update(seconds);
  is_drawing_picture() ? renderer_.hold_upload() : renderer_.upload(fine);
  if (renderer_.is_uploaded()) continue_picture(false);
  draw_scene(fine);
  gui_.begin(seconds);
  panel(*this);
  legend(*this);
  probe_card(*this);
  profile_card(*this);
  key_line(*this);
  dialogs(*this);
  gui_.draw();
}

}  // namespace luxel
