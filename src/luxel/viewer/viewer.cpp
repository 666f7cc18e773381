// SPDX-License-Identifier: Apache-2.0
#include "luxel/viewer/viewer.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "luxel/render/automatic_camera.h"
#include "luxel/viewer/panels.h"

namespace luxel {
namespace {

constexpr double upload_seconds = 0.005;  // of a frame, for what goes to the card
constexpr double said_seconds = 4.0;
// Where a processor draws, while something moves: each where a frame took longer than that of late, s, by the
// one before. Then a single long one may be seen.
constexpr std::array moving_edges = {EdgeSmoothing::rough, EdgeSmoothing::coarse, EdgeSmoothing::coarsest};
constexpr std::array slow_frame = {0.020, 0.022};
constexpr double longest_counted = 0.05;  // s: one frame in which the driver compiles says nothing

Bounds box_of(const PatchSet& patches) {
  Bounds box;
  for (const auto& corners : patches.corners)
    for (const auto corner : corners) box.add(patches.vertices[corner]);
  return box;
}

}  // namespace

Viewer::Viewer(Screen& screen, const WindowSettings& its_settings)
    : session(its_settings.live),
      navigator([this](float x, float y) -> std::optional<Vec3> {
        if (!session.mesh() || !session.mesh()->tracer) return std::nullopt;
        const auto seen = sight(navigator.pose(), navigator.space(), navigator.aspect(), x, y);
        const auto hit = session.mesh()->tracer->nearest({seen.origin, seen.direction});
        if (!hit) return std::nullopt;
        return seen.origin + hit.distance * seen.direction;
      }),
      settings(its_settings),
      screen_(screen),
      gui_(screen) {
  look.tone = settings.tone;
  navigator.set_screen(screen.size());
  if (!settings.file.empty()) open(settings.file);
}

void Viewer::say(std::string sentence) {
  said_ = std::move(sentence);
  said_left_ = said_seconds;
}

void Viewer::complain(std::string sentence) {
  errors_.push_back(sentence);
  dialogs.push_back(std::move(sentence));
}

// ---- A scene ----

void Viewer::begin_scene() {
  if (picture_ && !picture_->is_drawn()) {
    complain(fmt::format("{} is not made: another scene was opened", picture_->file().string()));
    picture_.reset();
  }
  scene_ = session.number();
  has_space_ = has_home_ = false;
  messages_seen_ = 0;
  lamps = lamps_asked = {};
  bounces.reset();
  faults_.reset();
  asked_faults_ = false;
  compared_with_.clear();
  exposure_.forget();
  inquiry.forget();
  instruments.forget();
  screen_.set_title(fmt::format("{} - Luxel", session.title()));
  if (settings.compare && scene_ == 1) compare(*settings.compare);
}

void Viewer::find_home() {
  const auto& mesh = session.mesh();
  if (!has_space_) {
    const auto& patches = *mesh->patches;
    navigator.set_space(Space(settings.up.value_or(automatic_up(patches))), box_of(patches));
    has_space_ = true;
    if (settings.eye && settings.target && scene_ == 1) {
      const Camera camera{.eye = Vec3(*settings.eye - patches.origin),
                          .target = Vec3(*settings.target - patches.origin),
                          .vertical_fov = settings.vertical_fov > 0.0f ? settings.vertical_fov : 50.0f};
      navigator.set_home(pose_of(camera, navigator.space()), false);
      has_home_ = true;
    } else if (mesh->scene && !mesh->scene->cameras.empty()) {
      navigator.set_home(pose_of(mesh->scene->cameras.front(), navigator.space()), false);
      has_home_ = true;
    }
  }
  if (const auto found = diagnostic_home_.take(); found && found->scene == scene_ && !has_home_) {
    navigator.set_home(found->pose, true);
    has_home_ = true;
  }
  // The view is judged by the first light; where none will come, by the surfaces.
  const bool has_light_to_judge = session.light() || session.status().is_idle;
  if (has_home_ || diagnostic_home_.is_busy() || !mesh->tracer || !has_light_to_judge) return;
  diagnostic_home_.start([mesh, light = session.light(), space = navigator.space(),
                          aspect = navigator.aspect(), scene = scene_] {
    const Solution nothing;
    const auto camera =
        automatic_camera(*mesh->patches, light ? light->solution : nothing, *mesh->tracer, Workers(1),
                         space.up, std::clamp(aspect, smallest_aspect, max_aspect));
    return FoundHome{scene, pose_of(camera, space)};
  });
}

void Viewer::update(double seconds) {
  session.update();
  for (auto& error : session.take_errors()) complain(std::move(error));
  if (session.number() != scene_) begin_scene();
  if (!session.has_scene()) return;
  const auto& messages = session.status().messages;
  for (; messages_seen_ < messages.size(); ++messages_seen_) say(messages[messages_seen_].text);
  if (!session.mesh()) return;
  // The patches that are lit come after those of the grey preview.
  if (const auto& patches = session.mesh()->patches; patches != patches_) {
    patches_ = patches;
    lamps = lamps_asked = LampBoard(*patches);
  }
  find_home();
  ask(seconds);
}

// What follows from where one looks, and from newer light.
void Viewer::ask(double seconds) {
  const auto& mesh = session.mesh();
  const auto& light = session.light();
  const float aspect = navigator.aspect();
  inquiry.look_at(*mesh, light.get(), navigator.pose(), navigator.space(), aspect, navigator.aim());
  inquiry.update_profile(*mesh, light.get());
  if (look.diagnostics && !faults_) {
    if (!asked_faults_) session.live().request_diagnostics();
    asked_faults_ = true;
    faults_ = session.live().diagnostics();
  }
  // What a picture is being made of stays as it is, and what is seen with it.
  if (is_drawing_picture()) return;
  const auto& seen = seen_look();
  if (instruments.update(seen, mesh, light, inquiry, faults_)) painter_.set_marks(instruments.marks());
  curve_ = exposure_.curve(seen.tone, seen.automatic_exposure, light.get(), navigator.pose(),
                           navigator.space(), aspect, seconds);
  painter_.update(scene_, mesh, light, seen, session.live().difference());
}

// ---- A frame ----

Viewpoint Viewer::viewpoint() const {
  return {navigator.pose(), navigator.space(), navigator.box(), curve_, navigator.aspect()};
}

bool Viewer::is_at_rest() const {
  return is_uploaded_ && !picture_ && exposure_.is_settled() && !navigator.is_moving() && !session.is_busy();
}

void Viewer::note_changes() {
  const Shown now{navigator.pose(),      look,
                  curve_.scale,          session.light() ? session.light()->number : 0,
                  instruments.version(), screen_.pixels()};
  if (now == shown_ && is_uploaded_ && !line) {
    ++unchanged_frames_;
    return;
  }
  shown_ = now;
  unchanged_frames_ = 0;
  joined_ = 0;
}

// Where a processor draws, four samples per pixel take longer than a frame may: there edges are rough while
// something moves, and coarse where even that is slow, and afterwards rough pictures are joined, one a frame.
void Viewer::draw_scene(bool fine) {
  const bool is_rough = driver_.is_software && !fine;
  const bool is_moving = unchanged_frames_ == 0;
  // It stays so for this scene: quick coarse frames say nothing of what fine ones would take.
  if (slow_scene_ != scene_) slow_scene_ = scene_, coarseness_ = 0;
  if (is_rough && is_moving && coarseness_ < slow_frame.size() && frame_seconds_ > slow_frame[coarseness_]) {
    ++coarseness_;
    frame_seconds_ = 0.0;
  }
  const auto pixels = screen_.pixels();
  const bool joins = is_rough && unchanged_frames_ > 3;
  auto& frame = canvas_.frame;
  if (joins && joined_ >= shifts) return frame.show_joined();
  const Tile tile = joins ? shifted_tile(joined_, pixels) : Tile();
  const auto edges = !is_rough   ? EdgeSmoothing::sampled
                     : is_moving ? moving_edges[coarseness_]
                                 : EdgeSmoothing::rough;
  painter_.draw(canvas_, seen_look(), viewpoint(), {pixels, {}, pixels}, edges, 4.0f * screen_.text_scale(),
                tile);
  frame.resolve();
  if (joins) frame.join(joined_++);
}

// What is drawn into for the first time is made then, and its programs compiled: not while somebody moves.
void Viewer::try_edges() {
  tried_edges_ = true;
  const auto pixels = screen_.pixels();
  for (const auto edges : moving_edges) {
    painter_.draw(canvas_, look, viewpoint(), {pixels, {}, pixels}, edges, 4.0f * screen_.text_scale());
    painter_.try_programs();
    canvas_.frame.resolve();
  }
}

void Viewer::note_frame(double seconds) {
  frame_seconds_ += 0.2 * (std::min(seconds, longest_counted) - frame_seconds_);
}

void Viewer::frame(double seconds, bool fine) {
  said_left_ -= seconds;
  if (said_left_ <= 0.0) said_.clear();
  navigator.advance(seconds);
  update(seconds);
  is_uploaded_ = is_drawing_picture() || painter_.upload(fine ? 1.0 : upload_seconds);
  if (is_uploaded_) go_on_with_picture(false);
  note_changes();
  if (driver_.is_software && !fine && !tried_edges_) try_edges();
  draw_scene(fine);
  gui_.begin(seconds);
  panel(*this);
  legend(*this);
  probe_card(*this);
  profile_card(*this);
  key_line(*this);
  luxel::dialogs(*this);
  gui_.draw();
}

}  // namespace luxel
