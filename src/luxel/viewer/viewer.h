// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "luxel/viewer/camera_controller.h"
#include "luxel/viewer/current_session.h"
#include "luxel/viewer/exposure.h"
#include "luxel/viewer/gui.h"
#include "luxel/viewer/home_view.h"
#include "luxel/viewer/light_mixer.h"
#include "luxel/viewer/light_probe.h"
#include "luxel/viewer/look.h"
#include "luxel/viewer/notices.h"
#include "luxel/viewer/overlays.h"
#include "luxel/viewer/picture_maker.h"
#include "luxel/viewer/run_window.h"
#include "luxel/viewer/scene_renderer.h"

namespace luxel {

// Lamps, colours and bounces of the scene that is shown, as they are set in the window.
struct LightControls {
  LightMixer mixer;
  LightMixer sent;                          // the mixer's settings that the session has
  std::optional<int> bounces;               // that are shown; nothing: all
  std::shared_ptr<const PatchSet> patches;  // that the mixer is of
};

// What was asked about the scene that is shown.
struct SceneQueries {
  bool has_requested_diagnostics = false;
  std::shared_ptr<const CheckReport> diagnostics;  // null until they are found
  std::filesystem::path compared_with;             // a solution; empty: none
};

// The window: everything that is in it, and what a frame does. Its parts are open to the panels and to
// scripts, which do what a person could do with them.
class Viewer {
 public:
  // Keeps references.
  Viewer(Screen& screen, const WindowSettings& settings);
  Viewer(const Viewer&) = delete;
  Viewer& operator=(const Viewer&) = delete;

  void handle(const Event& event);
  // One frame, after so many seconds. fine: smooth edges whatever they cost.
  void frame(double seconds, bool fine);
  // How long the frame took as it was seen, s.
  void note_frame(double seconds) { renderer_.note_frame(seconds); }
  // The last frame's pixels.
  Image snapshot() const { return renderer_.snapshot(); }

  // ---- What a person can do ----
  void open(const std::filesystem::path& file) { session.open(file); }
  void relight();  // as the mixer is set
  // Tile by tile between frames, once all that was published is seen; until it is drawn, newer light and
  // other choices of what to show wait. One at a time.
  void save_picture(const std::filesystem::path& file, ScreenSize size);
  void continue_picture(bool to_the_end);  // else for a part of a frame
  void save_solution(const std::filesystem::path& file);
  void export_glb(const std::filesystem::path& file);
  void solve_by(Method method);
  void compare(const std::filesystem::path& file);  // the light with a second solution
  void show_bounces(std::optional<int> count);      // the light after so many; nothing: all of it
  void toggle_flying();
  void close() { is_closing_ = true; }

  // ---- What there is to wait for ----
  bool is_closing() const { return is_closing_; }
  bool has_view() const { return home_.is_known(); }
  // All that was published is seen, and nothing moves.
  bool is_at_rest() const;
  // Frames may wait for a person: another would be the same.
  bool may_sleep() const { return renderer_.may_sleep() && !picture_; }
  const PictureMaker* picture() const { return picture_.get(); }  // that is being made, or null

  const Painter& painter() const { return renderer_.painter(); }
  ScreenSize pixels() const { return screen_.pixels(); }

  CurrentSession session;
  Look look;
  CameraController camera;
  LightProbe light_probe;
  Overlays overlays;
  LightControls light;
  SceneQueries queries;
  Notices notices;
  const WindowSettings& settings;
  std::optional<std::pair<Vec2, Vec2>> line;  // being drawn over the screen, [-1, 1]

 private:
  void handle_key(Key key);
  void handle_line(const Event& event);
  void update(double seconds);
  void update_view(double seconds);
  void begin_scene();
  bool is_drawing_picture() const { return picture_ && picture_->has_begun() && !picture_->is_drawn(); }
  const Look& seen_look() const { return picture_ && !picture_->is_drawn() ? picture_->look() : look; }
  Viewpoint viewpoint() const;
  void draw_scene(bool fine);

  Screen& screen_;
  SceneRenderer renderer_;
  Gui gui_;
  std::unique_ptr<PictureMaker> picture_;
  Exposure exposure_;
  ToneCurve curve_;
  HomeView home_;
  std::uint64_t scene_ = 0;  // that this is set up for
  bool is_closing_ = false;
  bool mouse_is_for_panels_ = false;
};

}  // namespace luxel
