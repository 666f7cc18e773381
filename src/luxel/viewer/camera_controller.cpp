// SPDX-License-Identifier: Apache-2.0
#include "luxel/viewer/camera_controller.h"

#include <algorithm>
#include <cmath>

namespace luxel {
namespace {

constexpr float radians_per_pixel = 0.005f;
constexpr double glide_seconds = 0.25;
constexpr float faster = 4.0f;  // with shift
// Per turn of the wheel: of the distance, the same with shift, and of the scene's radius while flying. The
// first and the last are the HTML page's.
constexpr float zoom_of_wheel = 0.95f, faster_zoom_of_wheel = 0.84f, step_of_wheel = 0.06f;

constexpr float max_away = 20.0f;  // sizes of the scene, from its middle, by the wheel

float size_of(const Bounds& box) { return std::max(glm::length(box.size()), 1e-6f); }

}  // namespace

void CameraController::set_space(const Space& space, const Bounds& box) {
  space_ = space;
  box_ = box;
  speed_ = size_of(box) / 8.0f;
  views_ = {};
  glide_.reset();
  has_moved_ = false;
  home_ = pose_ = overview(box, space, aspect());
}

void CameraController::set_home(const Pose& pose, bool glides) {
  home_ = pose;
  if (has_moved_) return;
  if (glides) {
    glide(pose);
  } else {
    pose_ = pose;
  }
}

void CameraController::go_to(const Pose& pose) {
  glide_.reset();
  pose_ = pose;
  has_moved_ = true;
}

void CameraController::glide_to(const Pose& pose) {
  glide(pose);
  has_moved_ = true;
}

void CameraController::glide(const Pose& to) { glide_ = Glide{pose_, to, 0.0}; }

void CameraController::set_flying(bool flying) {
  is_flying_ = flying;
  knows_cursor_ = false;
  dragging_.reset();
}

bool CameraController::is_moving() const {
  if (glide_) return true;
  for (const Key key : {'W', 'A', 'S', 'D', 'Q', 'E'})
    if (is_down(key)) return true;
  return false;
}

float CameraController::aspect() const {
  return screen_.empty() ? 1.0f : static_cast<float>(screen_.width) / static_cast<float>(screen_.height);
}

Vec2 CameraController::aim() const {
  if (is_flying_ || screen_.empty()) return Vec2(0.0f);
  return {2.0f * cursor_.x / static_cast<float>(screen_.width) - 1.0f,
          1.0f - 2.0f * cursor_.y / static_cast<float>(screen_.height)};
}

bool CameraController::handle(const Event& event) {
  switch (event.kind) {
    case Event::Kind::key:
      return handle_key(event);
    case Event::Kind::button:
      handle_button(event);
      return true;
    case Event::Kind::move:
      handle_move(event.at);
      return true;
    case Event::Kind::wheel:
      return handle_wheel(event.at.y);
    default:
      return false;
  }
}

// As in the HTML page: approaches the surface under the cursor, or moves ahead while flying. With Control the
// wheel sets the window's exposure, or the speed while flying.
bool CameraController::handle_wheel(float turns) {
  if (is_down(key::control)) {
    if (!is_flying_) return false;
    speed_ = std::clamp(speed_ * std::exp2(0.25f * turns), size_of(box_) / 1000.0f, size_of(box_));
    return true;
  }
  if (is_flying_) {
    pose_ = fly(pose_, space_, Vec3(0.0f, 0.0f, 1.0f), turns * step_of_wheel * 0.5f * size_of(box_));
    has_moved_ = true;
    glide_.reset();
    return true;
  }
  approach_at(aim(), std::pow(is_down(key::shift) ? faster_zoom_of_wheel : zoom_of_wheel, turns));
  return true;
}

void CameraController::approach_at(const Vec2& place, float factor) {
  const auto seen = sight(pose_, space_, aspect(), place.x, place.y);
  const auto hit = pick_(place.x, place.y);
  const float far = std::max(glm::length(box_.center() - seen.origin), 0.1f * size_of(box_));
  const auto to = approach(pose_, hit.value_or(seen.origin + far * seen.direction), factor);
  const auto away = glm::length(to.eye - box_.center());
  if (away > max_away * size_of(box_) && away > glm::length(pose_.eye - box_.center())) return;
  pose_ = to;
  has_moved_ = true;
  glide_.reset();
}

void CameraController::zoom(float factor) { approach_at(Vec2(0.0f), factor); }

bool CameraController::handle_key(const Event& event) {
  if (event.key <= 0 || event.key >= key::count) return false;
  if (!event.down) {
    down_[static_cast<std::size_t>(event.key)] = false;
    return false;  // other listeners may need it
  }
  const bool with_control = is_down(key::control);
  const bool is_modifier = event.key == key::control || event.key == key::shift || event.key == key::alt;
  down_[static_cast<std::size_t>(event.key)] = !with_control || is_modifier;
  if (event.repeat) return false;
  if (event.key >= '1' && event.key <= '9') {
    const auto number = static_cast<std::size_t>(event.key - '1');
    if (with_control) {
      save_view(number);
    } else {
      recall_view(number);
    }
    return true;
  }
  if (with_control) return false;
  if (event.key == 'F') return focus(), true;
  if (event.key == 'H' || event.key == key::home) return home(), true;
  return false;
}

void CameraController::handle_button(const Event& event) {
  dragging_.reset();
  pivot_.reset();
  if (!event.down || is_flying_) return;
  travel_ = 0.0f;
  dragging_ = event.button;
  pivot_ = pick_(aim().x, aim().y);
}

void CameraController::handle_move(const Vec2& to) {
  const Vec2 by = knows_cursor_ ? to - cursor_ : Vec2(0.0f);
  cursor_ = to;
  knows_cursor_ = true;
  travel_ += glm::length(by);
  if (!is_flying_ && !dragging_) return;
  const float turn = by.x * radians_per_pixel, pitch = -by.y * radians_per_pixel;
  if (is_flying_) {
    pose_ = look(pose_, 0.5f * turn, 0.5f * pitch);
  } else if (*dragging_ == MouseButton::right) {
    pose_ = look(pose_, turn, pitch);
  } else if (*dragging_ == MouseButton::left) {
    // The scene follows the drag: it turns with the hand.
    pose_ = orbit(pose_, space_, pivot_.value_or(box_.center()), turn, pitch);
  } else {
    const auto a = axes(pose_, space_);
    const float depth = glm::dot(pivot_.value_or(box_.center()) - pose_.eye, a.ahead);
    const float metres = 2.0f * std::abs(depth) * std::tan(glm::radians(pose_.vertical_fov) * 0.5f) /
                         static_cast<float>(std::max(screen_.height, 1));
    pose_.eye += metres * (by.y * a.up - by.x * a.right);
  }
  if (by != Vec2(0.0f)) {
    glide_.reset();
    has_moved_ = true;
  }
}

void CameraController::advance(double seconds) {
  if (glide_) {
    glide_->fraction = std::min(1.0, glide_->fraction + seconds / glide_seconds);
    const auto s = static_cast<float>(glide_->fraction);
    pose_ = between(glide_->from, glide_->to, s * s * (3.0f - 2.0f * s));
    if (glide_->fraction >= 1.0) glide_.reset();
  }
  const auto pressed = [&](Key key) { return is_down(key) ? 1.0f : 0.0f; };
  const Vec3 way(pressed('D') - pressed('A'), pressed('E') - pressed('Q'), pressed('W') - pressed('S'));
  if (way == Vec3(0.0f)) return;
  const float metres = speed_ * static_cast<float>(seconds) * (is_down(key::shift) ? faster : 1.0f);
  pose_ = fly(pose_, space_, way, metres);
  has_moved_ = true;
  glide_.reset();
}

void CameraController::home() { glide(home_); }

void CameraController::focus() {
  const auto point = pick_(aim().x, aim().y);
  if (!point) return;
  glide(luxel::focus(pose_, space_, *point, 0.5f * glm::length(*point - pose_.eye)));
  has_moved_ = true;
}

void CameraController::save_view(std::size_t number) { views_[number] = glide_ ? glide_->to : pose_; }

bool CameraController::recall_view(std::size_t number) {
  if (!views_[number]) return false;
  glide(*views_[number]);
  has_moved_ = true;
  return true;
}

}  // namespace luxel
