// SPDX-License-Identifier: Apache-2.0
#include "luxel/viewer/scene_renderer.h"

#include <algorithm>
#include <array>

namespace luxel {
namespace {

// Smoothing while something moves, with a software renderer. Each entry replaces the previous one where
// recent frames took longer than slow_frame, s. A single long frame may remain visible.
constexpr std::array moving_edges = {EdgeSmoothing::rough, EdgeSmoothing::coarse, EdgeSmoothing::coarsest};
constexpr std::array slow_frame = {0.020, 0.022};
constexpr double longest_counted = 0.05;  // s: a frame in which the driver compiles is not representative
constexpr float mark_size = 4.0f;         // points
constexpr int frames_until_joins = 3;     // that are the same

}  // namespace

void SceneRenderer::note_changes(const Shown& now, bool is_dragging) {
  const auto size = screen_.pixels();
  if (now == shown_ && size == size_ && is_uploaded_ && !is_dragging) {
    ++unchanged_frames_;
    return;
  }
  shown_ = now;
  size_ = size;
  unchanged_frames_ = 0;
  joined_ = 0;
}

// With a software renderer, four samples per pixel take longer than a frame may: edges are rough while
// something moves, and coarse where even that is slow.
void SceneRenderer::draw(const Shown& now, const Look& look, const Viewpoint& from, bool is_dragging,
                         bool fine) {
  note_changes(now, is_dragging);
  const bool is_rough = driver_.is_software;
  auto& frame = canvas_.frame;
  if (fine) {
    while (joined_ < shifts) join_one_more(look, from);
    return frame.show_joined();
  }
  if (is_rough && !has_compiled_) compile_programs(look, from);
  const bool is_moving = unchanged_frames_ == 0;
  // Stays so for this scene: fast coarse frames do not predict the time of fine ones.
  if (slow_scene_ != now.scene) slow_scene_ = now.scene, coarseness_ = 0;
  if (is_rough && is_moving && coarseness_ < slow_frame.size() && frame_seconds_ > slow_frame[coarseness_]) {
    ++coarseness_;
    frame_seconds_ = 0.0;
  }
  if (unchanged_frames_ > frames_until_joins) {
    if (joined_ < shifts) join_one_more(look, from);
    return frame.show_joined();
  }
  const auto pixels = screen_.pixels();
  const auto edges = !is_rough   ? EdgeSmoothing::sampled
                     : is_moving ? moving_edges[coarseness_]
                                 : EdgeSmoothing::rough;
  painter_.draw(canvas_, look, from, {{pixels, {}, pixels}, edges, mark_size * screen_.text_scale()});
  frame.resolve();
}

void SceneRenderer::join_one_more(const Look& look, const Viewpoint& from) {
  const auto pixels = screen_.pixels();
  const auto edges = driver_.is_software ? EdgeSmoothing::rough : EdgeSmoothing::sampled;
  painter_.draw(
      canvas_, look, from,
      {{pixels, {}, pixels}, edges, mark_size * screen_.text_scale(), shifted_tile(joined_, pixels)});
  canvas_.frame.resolve();
  canvas_.frame.join(joined_++);
}

// Creates targets and compiles programs on the first draw, before the user moves.
void SceneRenderer::compile_programs(const Look& look, const Viewpoint& from) {
  has_compiled_ = true;
  const auto pixels = screen_.pixels();
  for (const auto edges : moving_edges) {
    painter_.draw(canvas_, look, from, {{pixels, {}, pixels}, edges, mark_size * screen_.text_scale()});
    painter_.try_programs();
    canvas_.frame.resolve();
  }
}

void SceneRenderer::note_frame(double seconds) {
  frame_seconds_ += 0.2 * (std::min(seconds, longest_counted) - frame_seconds_);
}

}  // namespace luxel
