// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "luxel/viewer/painter.h"
#include "luxel/viewer/screen.h"

namespace luxel {

// Draws the scene behind the panels, frame by frame: pictures of a view that stays are averaged, and where a
// processor draws, edges are as rough as the frame rate needs while something moves.
class SceneRenderer {
 public:
  explicit SceneRenderer(Screen& screen) : screen_(screen) {}

  // Contents of a frame. While they are the same, edges become smoother; then frames may be skipped.
  struct Shown {
    std::uint64_t scene = 0;
    Pose pose = {};
    Look look = {};
    float scale = 0.0f;  // of the tone curve
    std::uint64_t light = 0, marks = 0;
    bool operator==(const Shown&) const = default;
  };

  Painter& painter() { return painter_; }
  const Painter& painter() const { return painter_; }
  bool is_software() const { return driver_.is_software; }  // a processor draws

  // Uploads the painter's data to the graphics card for about this many seconds.
  void upload(double seconds) { is_uploaded_ = painter_.upload(seconds); }
  // Suspends uploads while a picture is drawn.
  void hold_upload() { is_uploaded_ = true; }
  bool is_uploaded() const { return is_uploaded_; }  // all of it

  // is_dragging: something is drawn by hand over the scene. fine: smooth edges at any cost.
  void draw(const Shown& now, const Look& look, const Viewpoint& from, bool is_dragging, bool fine);
  // Records the visible duration of the frame, s.
  void note_frame(double seconds);
  // Edges are as smooth as they get: another frame would be the same.
  bool is_smooth() const { return joined_ >= shifts; }
  // The last frame's pixels.
  Image snapshot() const { return canvas_.frame.read(); }

 private:
  void note_changes(const Shown& now, bool is_dragging);
  void join_one_more(const Look& look, const Viewpoint& from);
  void compile_programs(const Look& look, const Viewpoint& from);

  Screen& screen_;
  Driver driver_ = current_driver();
  Painter painter_;
  Canvas canvas_;
  bool is_uploaded_ = false, has_compiled_ = false;
  Shown shown_;
  ScreenSize size_;
  int unchanged_frames_ = 0;      // since the scene or the view changed
  std::uint64_t slow_scene_ = 0;  // with frames that took too long
  std::size_t coarseness_ = 0;    // their antialiasing while something moves
  int joined_ = 0;                // pictures joined into the one that is seen
  double frame_seconds_ = 0.0;    // lately
};

}  // namespace luxel
