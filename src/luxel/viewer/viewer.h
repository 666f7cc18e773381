// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "luxel/viewer/background.h"
#include "luxel/viewer/exposure.h"
#include "luxel/viewer/gui.h"
#include "luxel/viewer/inquiry.h"
#include "luxel/viewer/instruments.h"
#include "luxel/viewer/lamp_board.h"
#include "luxel/viewer/look.h"
#include "luxel/viewer/navigator.h"
#include "luxel/viewer/painter.h"
#include "luxel/viewer/picture_maker.h"
#include "luxel/viewer/run_window.h"
#include "luxel/viewer/session.h"

namespace luxel {

// The window itself: everything that is in it, and what a frame does. The parts are open to the panels and
// to scripts, which do what a person could do with them.
class Viewer {
 public:
  // Keeps references.
  Viewer(Screen& screen, const WindowSettings& settings);
  Viewer(const Viewer&) = delete;
  Viewer& operator=(const Viewer&) = delete;

  void handle(const Event& event);
  // One frame, and what happens meanwhile in so many seconds. fine: smooth edges whatever they cost.
  void frame(double seconds, bool fine);
  // How long that took, s, as it was seen.
  void note_frame(double seconds);
  // The last frame's pixels.
  Image snapshot() const { return canvas_.frame.read(); }

  // ---- What a person can do ----
  void open(const std::filesystem::path& file) { session.open(file); }
  void relight();  // as the lamp board says
  // Tile by tile between frames, once all that was put out is seen; until it is drawn, newer light and other
  // choices of what to show wait. One at a time.
  void save_picture(const std::filesystem::path& file, ScreenSize size);
  void go_on_with_picture(bool to_the_end);  // else for a part of a frame
  void save_solution(const std::filesystem::path& file);
  void export_glb(const std::filesystem::path& file);
  void solve_by(const std::string& method);
  void compare(const std::filesystem::path& file);  // the light with a second solution
  void show_bounces(std::optional<int> count);      // the light after so many; nothing: all of it
  void toggle_flying();
  void close() { is_closing_ = true; }

  // ---- What there is to wait for ----
  bool is_closing() const { return is_closing_; }
  bool has_view() const { return has_home_; }  // home is known
  // All that was put out is seen, and nothing moves.
  bool is_at_rest() const;
  // Frames may wait for a person: another would be the same.
  bool may_sleep() const { return unchanged_frames_ > 12 && !picture_; }
  const PictureMaker* picture() const { return picture_.get(); }      // that is being made, or null
  const std::vector<std::string>& errors() const { return errors_; }  // all there were
  void say(std::string sentence);                                     // on the screen for a few seconds
  void complain(std::string sentence);                                // in a dialog

  Session session;
  Look look;
  Navigator navigator;
  Inquiry inquiry;
  Instruments instruments;
  LampBoard lamps;
  LampBoard lamps_asked;       // as the solver was told
  std::optional<int> bounces;  // that are shown
  const WindowSettings& settings;
  std::deque<std::string> dialogs;            // errors to be read, the first is shown
  std::optional<std::pair<Vec2, Vec2>> line;  // being drawn over the screen, [-1, 1]
  const Painter& painter() const { return painter_; }
  ScreenSize pixels() const { return screen_.pixels(); }
  const std::string& said() const { return said_; }
  const std::filesystem::path& compared_with() const { return compared_with_; }
  const std::shared_ptr<const CheckReport>& diagnostics() const { return faults_; }  // null: not known yet

 private:
  void handle_key(Key key);
  void handle_line(const Event& event);
  void update(double seconds);
  void begin_scene();
  void find_home();
  void ask(double seconds);
  bool is_drawing_picture() const { return picture_ && picture_->has_begun() && !picture_->is_drawn(); }
  const Look& seen_look() const { return picture_ && !picture_->is_drawn() ? picture_->look() : look; }
  void draw_scene(bool fine);
  void try_edges();
  Viewpoint viewpoint() const;
  void note_changes();

  Screen& screen_;
  Driver driver_ = current_driver();
  Gui gui_;
  Painter painter_;
  Canvas canvas_;
  std::unique_ptr<PictureMaker> picture_;
  Exposure exposure_;
  ToneCurve curve_;
  struct FoundHome {
    std::uint64_t scene;
    Pose pose;
  };
  Background<FoundHome> diagnostic_home_;
  std::uint64_t scene_ = 0;  // that this is set up for
  bool has_space_ = false, has_home_ = false, is_closing_ = false, is_uploaded_ = false;
  std::shared_ptr<const PatchSet> patches_;  // that the lamp board is of
  std::vector<std::string> errors_;
  std::shared_ptr<const CheckReport> faults_;
  bool asked_faults_ = false;
  std::filesystem::path compared_with_;
  std::string said_;
  double said_left_ = 0.0, frame_seconds_ = 0.0;
  std::size_t messages_seen_ = 0;
  bool mouse_is_for_panels_ = false;

  // What the last frame showed: while it stays, edges get smoother, and then frames may wait.
  struct Shown {
    Pose pose;
    Look look;
    float scale = 0.0f;
    std::uint64_t light = 0, marks = 0;
    ScreenSize size;
    bool operator==(const Shown&) const = default;
  } shown_;
  int unchanged_frames_ = 0;      // since the scene, the view or an event changed
  std::uint64_t slow_scene_ = 0;  // whose frames took too long
  bool tried_edges_ = false;
  std::size_t coarseness_ = 0;  // and what they are drawn by while something moves
  int joined_ = 0;              // rough pictures joined into the one that is seen
};

}  // namespace luxel
