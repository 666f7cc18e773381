// SPDX-License-Identifier: Apache-2.0
#include "luxel/viewer/viewer.h"

#include <algorithm>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "luxel/viewer/menus.h"
#include "luxel/viewer/panels.h"

namespace luxel {
namespace {

// Dear ImGui lays a window out over a few frames, and the driver averages pictures of a view that stays.
constexpr int frames_per_event = 12;
// Between frames while the light is solved and nothing moves: while a newer light becomes visible, and while
// only the panel's numbers change. A frame of the software renderer takes 20 ms of the solver's cores.
constexpr double solving_frame = 0.25, panel_frame = 0.5;                // s
constexpr double paused_frame = 1.0;                                     // s
constexpr double upload_seconds = 0.005, upload_seconds_at_rest = 0.05;  // per frame, to the graphics card

}  // namespace

Viewer::Viewer(Screen& screen, const WindowSettings& its_settings)
    : session(its_settings.live),
      camera([this](float x, float y) -> std::optional<Vec3> {
        if (!session.mesh() || !session.mesh()->tracer) return std::nullopt;
        const auto seen = sight(camera.pose(), camera.space(), camera.aspect(), x, y);
        const auto hit = session.mesh()->tracer->nearest({seen.origin, seen.direction});
        if (!hit) return std::nullopt;
        return seen.origin + hit.distance * seen.direction;
      }),
      recent(its_settings.recent),
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
  recent.add(session->file());
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
  const bool was_busy = session.is_busy();
  session.update();
  if (was_busy && !session.is_busy()) frames_since_event_ = 0;
  for (auto& error : session.take_errors()) notices.complain(std::move(error));
  if (session.number() != scene_) begin_scene();
  if (!session.has_scene()) return;
  notices.say_new(session.status().messages);
  if (!session.mesh()) return;
  // The patches that get light come after those of the grey preview.
  if (const auto& patches = session.mesh()->patches; patches != light.patches) {
    light.patches = patches;
    light.mixer = light.sent = LightMixer(*patches);
    light.history.reset(light.mixer);
  }
  home_.update(session, settings, camera);
  update_view(seconds);
}

// Updates everything that depends on the view or on newer light.
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
  // While a picture is drawn, its data and its view stay unchanged.
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

// By rays all over the view.
float Viewer::empty_distance() const {
  constexpr int columns = 12, rows = 8;
  if (!session.mesh() || !session.mesh()->tracer) return 0.0f;
  auto nearest = std::numeric_limits<float>::infinity();
  for (int i = 0; i < columns * rows; ++i) {
    const auto at = [](int place, int of) {
      return 2.0f * (static_cast<float>(place) + 0.5f) / static_cast<float>(of) - 1.0f;
    };
    const auto seen = sight(camera.pose(), camera.space(), camera.aspect(), at(i % columns, columns),
                            at(i / columns, rows));
    if (const auto hit = session.mesh()->tracer->nearest({seen.origin, seen.direction}))
      nearest = std::min(nearest, hit.distance);
  }
  return nearest;
}

Viewpoint Viewer::viewpoint() const {
  return {camera.pose(), camera.space(), camera.box(), curve_, camera.aspect(), empty_distance()};
}

bool Viewer::is_at_rest() const {
  return renderer_.is_uploaded() && !picture_ && exposure_.is_settled() && !camera.is_moving() &&
         !session.is_busy();
}

std::optional<double> Viewer::next_frame() const {
  if (frames_since_event_ < frames_per_event || picture_ || camera.is_moving() || line || gui_.is_pressed())
    return 0.0;
  const bool is_settled = renderer_.is_uploaded() && renderer_.is_smooth() && exposure_.is_settled();
  if (session.is_busy()) {
    if (!is_settled || !session.has_scene() || !session.light()) return solving_frame;
    return session.status().is_paused ? paused_frame : panel_frame;
  }
  if (!is_settled || home_.is_searching()) return 0.0;
  if (!notices.said().empty() || gui_.is_typing()) return solving_frame;
  return std::nullopt;
}

void Viewer::draw_scene(bool fine) {
  const auto& newest = session.light();
  renderer_.draw({scene_, camera.pose(), look, curve_.scale, newest ? newest->number : 0, overlays.version()},
                 seen_look(), viewpoint(), line.has_value(), fine);
}

void Viewer::draw_panels(double seconds) {
  gui_.begin(seconds);
  top_ = menu_bar(*this);
  panel(*this);
  legend(*this);
  probe_card(*this);
  profile_card(*this);
  key_line(*this);
  key_card(*this);
  about_card(*this);
  file_dialog.draw();
  dialogs(*this);
  gui_.draw();
  if (!gui_.is_editing()) light.history.note(light.mixer);
}

void Viewer::frame(double seconds, bool fine) {
  ++frames_since_event_;
  notices.advance(seconds);
  camera.advance(seconds);
  update(seconds);
  if (is_drawing_picture()) {
    renderer_.hold_upload();
  } else {
    renderer_.upload(fine ? 1.0 : next_frame() == 0.0 ? upload_seconds : upload_seconds_at_rest);
  }
  if (renderer_.is_uploaded()) continue_picture(false);
  draw_scene(fine);
  draw_panels(seconds);
}

}  // namespace luxel
