// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <optional>

#include "luxel/viewer/event.h"
#include "luxel/viewer/pose.h"
#include "luxel/viewer/screen.h"

namespace luxel {

// Moves the eye by keys and mouse. Two modes: while flying the mouse looks around and the cursor is captured;
// else the cursor is free, and the mouse turns the scene about the point under it.
class CameraController {
 public:
  // Returns the surface point at a place of the screen, in [-1, 1] from the left and the bottom, if any.
  using Pick = std::function<std::optional<Vec3>(float x, float y)>;

  explicit CameraController(Pick pick) : pick_(std::move(pick)) {}

  // Sets up and size of another scene. Speeds scale with the size. Discards saved views.
  void set_space(const Space& space, const Bounds& box);
  void set_screen(ScreenSize size) { screen_ = size; }
  // Sets the initial pose, to which home() returns. Goes there unless the eye has been moved since the last
  // set_space(); glide: within a quarter of a second instead of at once.
  void set_home(const Pose& pose, bool glide);
  void go_to(const Pose& pose);     // at once
  void glide_to(const Pose& pose);  // within a quarter of a second

  bool handle(const Event& event);  // true where the event was used
  void advance(double seconds);

  const Pose& pose() const { return pose_; }
  const Space& space() const { return space_; }
  const Bounds& box() const { return box_; }
  bool is_flying() const { return is_flying_; }
  void set_flying(bool flying);
  bool is_moving() const;
  bool is_shifted() const { return is_down(key::shift); }
  bool has_control() const { return is_down(key::control); }
  // Scales the distance to the surface in the middle of the screen by this factor.
  void zoom(float factor);
  // Treats all keys as released, for when another window receives their release.
  void release_keys() { down_ = {}; }
  // Returns whether the cursor did not move while the last button was pressed.
  bool is_click() const { return travel_ < 4.0f; }
  float speed() const { return speed_; }  // m/s
  Vec2 cursor() const { return cursor_; }
  // Place of the cursor while it is free, the middle while flying: in [-1, 1].
  Vec2 aim() const;
  float aspect() const;

  void home();
  void focus();
  static constexpr std::size_t views = 9;
  void save_view(std::size_t number);  // 0 to views - 1
  bool recall_view(std::size_t number);
  bool has_view(std::size_t number) const { return views_[number].has_value(); }

 private:
  bool handle_key(const Event& event);
  void handle_button(const Event& event);
  void handle_move(const Vec2& to);
  bool handle_wheel(float turns);
  // Scales the distance to the surface at a point of the screen, or else to the middle of the scene.
  void approach_at(const Vec2& place, float factor);
  void glide(const Pose& to);
  bool is_down(Key key) const { return down_[static_cast<std::size_t>(key)]; }

  Pick pick_;
  Space space_;
  Bounds box_;
  ScreenSize screen_;
  Pose pose_, home_;
  float speed_ = 1.0f;
  bool is_flying_ = false, has_moved_ = false;
  std::array<bool, key::count> down_{};
  Vec2 cursor_{0.0f};
  bool knows_cursor_ = false;
  float travel_ = 0.0f;  // of the cursor since a button went down
  std::optional<MouseButton> dragging_;
  std::optional<Vec3> pivot_;
  std::array<std::optional<Pose>, views> views_;
  // A movement from one pose to another, and its progress.
  struct Glide {
    Pose from, to;
    double fraction;
  };
  std::optional<Glide> glide_;
};

}  // namespace luxel
