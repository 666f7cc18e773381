// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "luxel/viewer/camera_controller.h"
#include "luxel/viewer/current_session.h"
#include "luxel/viewer/edit_history.h"
#include "luxel/viewer/exposure.h"
#include "luxel/viewer/file_dialog.h"
#include "luxel/viewer/gui.h"
#include "luxel/viewer/home_view.h"
#include "luxel/viewer/light_mixer.h"
#include "luxel/viewer/light_probe.h"
#include "luxel/viewer/look.h"
#include "luxel/viewer/notices.h"
#include "luxel/viewer/overlays.h"
#include "luxel/viewer/picture_maker.h"
#include "luxel/viewer/recent_files.h"
#include "luxel/viewer/run_window.h"
#include "luxel/viewer/scene_renderer.h"

namespace luxel {

// Lamps, colours and bounces of the scene that is shown, as they are set in the window.
struct LightControls {
  LightMixer mixer;
  LightMixer sent;                          // the mixer's settings that the session has
  EditHistory<LightMixer> history;          // of the mixer
  std::optional<int> bounces;               // that are shown; nothing: all
  std::shared_ptr<const PatchSet> patches;  // that the mixer is of
};

// Queries about the displayed scene.
struct SceneQueries {
  bool has_requested_diagnostics = false;
  std::shared_ptr<const CheckReport> diagnostics;  // null until they are found
  std::filesystem::path compared_with;             // a solution; empty: none
};

// The window: its contents and the work of a frame. Its parts are accessible to the panels and to scripts,
// which can do the same as a user.
class Viewer {
 public:
  // Keeps references.
  Viewer(Screen& screen, const WindowSettings& settings);
  Viewer(const Viewer&) = delete;
  Viewer& operator=(const Viewer&) = delete;

  void handle(const Event& event);
  // Draws one frame, `seconds` after the last. fine: smooth edges at any cost.
  void frame(double seconds, bool fine);
  // Records the visible duration of the frame, s.
  void note_frame(double seconds) { renderer_.note_frame(seconds); }
  // The last frame's pixels.
  Image snapshot() const { return renderer_.snapshot(); }

  // ---- What a person can do ----
  void open(const std::filesystem::path& file) { session.open(file); }
  // Opens the first scene or solution among files dropped on the window, one path per line.
  void drop(const std::string& files);
  void relight();  // as the mixer is set
  // Restore the lamps and colours before the last change, and after the last undone one. No effect
  // where there is none.
  void undo_light();
  void redo_light();
  void switch_lamp(std::size_t group);  // off, or on as the scene has it
  void reset_light();                   // as the scene has it
  void change_exposure(int steps);      // quarters of a stop
  void toggle_pause();
  // Draws the picture tile by tile between frames, once all published data are shown; until then, newer light
  // and other display settings wait. One at a time.
  void save_picture(const std::filesystem::path& file, ScreenSize size);
  void continue_picture(bool to_the_end);  // else for a part of a frame
  void save_solution(const std::filesystem::path& file);
  void export_glb(const std::filesystem::path& file);
  void solve_by(Method method);
  void compare(const std::filesystem::path& file);  // the light with a second solution
  void show_bounces(std::optional<int> count);      // the light after `count`; nothing: all of it
  void toggle_flying();
  void toggle_full_screen();
  void go_to_file_view(std::size_t number);  // below file_views()
  // Each opens a dialog.
  void ask_open();
  void ask_compare();
  void ask_save_solution();
  void ask_save_picture();
  void ask_export();
  void close() { is_closing_ = true; }

  // ---- What there is to wait for ----
  bool is_closing() const { return is_closing_; }
  bool has_view() const { return home_.is_known(); }
  // Returns whether all published data are shown and nothing moves.
  bool is_at_rest() const;
  // Seconds from the last frame to the next useful one, unless an event comes: 0 while something moves, a
  // quarter of a second or more while the light is solved for a camera that stands still. Nothing: another
  // frame would be the same.
  std::optional<double> next_frame() const;
  const PictureMaker* picture() const { return picture_.get(); }  // that is being made, or null

  const Painter& painter() const { return renderer_.painter(); }
  ScreenSize pixels() const { return screen_.pixels(); }
  bool is_full_screen() const { return screen_.is_full_screen(); }
  std::size_t file_views() const;     // cameras of the scene's file
  float top() const { return top_; }  // below the menus, in the cursor's units

  CurrentSession session;
  Look look;
  CameraController camera;
  LightProbe light_probe;
  Overlays overlays;
  LightControls light;
  SceneQueries queries;
  Notices notices;
  RecentFiles recent;
  FileDialog file_dialog;
  const WindowSettings& settings;
  std::optional<std::pair<Vec2, Vec2>> line;  // being drawn over the screen, [-1, 1]

 private:
  void handle_key(Key key);
  void handle_shortcut(Key key);  // with Control
  void set_light(const LightMixer& mixer);
  void ask_save(const char* title, const char* ending,
                std::function<void(const std::filesystem::path&)> save);
  void handle_line(const Event& event);
  void update(double seconds);
  void update_view(double seconds);
  void begin_scene();
  bool is_drawing_picture() const { return picture_ && picture_->has_begun() && !picture_->is_drawn(); }
  const Look& seen_look() const { return picture_ && !picture_->is_drawn() ? picture_->look() : look; }
  float empty_distance() const;
  Viewpoint viewpoint() const;
  void draw_scene(bool fine);
  void draw_panels(double seconds);

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
  int frames_since_event_ = 0;
  float top_ = 0.0f;
};

}  // namespace luxel
