// SPDX-License-Identifier: Apache-2.0
#include "luxel/viewer/pose.h"

#include <algorithm>
#include <cmath>

#include "luxel/core/matrix.h"

namespace luxel {
namespace {

Vec3 unit_or(const Vec3& v, const Vec3& otherwise) {
  const float length = glm::length(v);
  return length > 0.0f ? v / length : otherwise;
}

// Turn and pitch of a direction, unit.
void aim(Pose& pose, const Space& space, const Vec3& direction) {
  const float ahead = glm::dot(direction, space.ahead), right = glm::dot(direction, space.right);
  if (std::hypot(ahead, right) > 1e-6f) pose.turn = std::atan2(right, ahead);
  pose.pitch =
      std::clamp(std::asin(std::clamp(glm::dot(direction, space.up), -1.0f, 1.0f)), -steepest, steepest);
}

float tangent_of_half(const Pose& pose) { return std::tan(glm::radians(pose.vertical_fov) * 0.5f); }

}  // namespace

Space::Space(const Vec3& its_up) : up(unit_or(its_up, Vec3(0.0f, 1.0f, 0.0f))), ahead(0.0f), right(0.0f) {
  const Vec3 level = std::abs(up.z) > 0.9f ? Vec3(0.0f, 1.0f, 0.0f) : Vec3(0.0f, 0.0f, -1.0f);
  ahead = glm::normalize(level - glm::dot(level, up) * up);
  right = glm::cross(ahead, up);
}

Axes axes(const Pose& pose, const Space& space) {
  const float ct = std::cos(pose.turn), st = std::sin(pose.turn);
  const float cp = std::cos(pose.pitch), sp = std::sin(pose.pitch);
  const Vec3 level = ct * space.ahead + st * space.right;
  return {ct * space.right - st * space.ahead, cp * space.up - sp * level, cp * level + sp * space.up};
}

Pose pose_of(const Camera& camera, const Space& space) {
  Pose pose{.eye = camera.eye, .vertical_fov = camera.vertical_fov};
  aim(pose, space, unit_or(camera.target - camera.eye, space.ahead));
  return pose;
}

Camera camera_of(const Pose& pose, const Space& space, float distance) {
  return {.eye = pose.eye,
          .target = pose.eye + distance * axes(pose, space).ahead,
          .up = space.up,
          .vertical_fov = pose.vertical_fov};
}

Pose look(Pose pose, float turn, float pitch) {
  pose.turn = std::remainder(pose.turn + turn, 2.0f * pi);
  pose.pitch = std::clamp(pose.pitch + pitch, -steepest, steepest);
  return pose;
}

Pose fly(Pose pose, const Space& space, const Vec3& right_up_ahead, float metres) {
  const auto a = axes(pose, space);
  const Vec3 way = right_up_ahead.x * a.right + right_up_ahead.y * space.up + right_up_ahead.z * a.ahead;
  pose.eye += metres * unit_or(way, Vec3(0.0f));
  return pose;
}

Pose orbit(const Pose& pose, const Space& space, const Vec3& pivot, float turn, float pitch) {
  const auto before = axes(pose, space);
  const Vec3 offset = pivot - pose.eye;
  auto turned = look(pose, turn, pitch);
  const auto after = axes(turned, space);
  turned.eye =
      pivot - (glm::dot(offset, before.right) * after.right + glm::dot(offset, before.up) * after.up +
               glm::dot(offset, before.ahead) * after.ahead);
  return turned;
}

Pose approach(Pose pose, const Vec3& point, float factor) {
  pose.eye = point + factor * (pose.eye - point);
  return pose;
}

Pose focus(const Pose& pose, const Space& space, const Vec3& point, float distance) {
  auto focused = pose;
  aim(focused, space, unit_or(point - pose.eye, axes(pose, space).ahead));
  focused.eye = point - distance * axes(focused, space).ahead;
  return focused;
}

Pose overview(const Bounds& box, const Space& space, float aspect, float vertical_fov) {
  Pose pose{.turn = -0.6f, .pitch = -0.45f, .vertical_fov = vertical_fov};
  const float radius = 0.5f * glm::length(box.size());
  const float tangent = tangent_of_half(pose) * std::min(1.0f, aspect);
  const float distance = radius * std::sqrt(1.0f + 1.0f / (tangent * tangent));
  pose.eye = box.center() - distance * axes(pose, space).ahead;
  return pose;
}

Pose between(const Pose& from, const Pose& to, float fraction) {
  const auto mix = [fraction](float a, float b) { return a + fraction * (b - a); };
  return {.eye = glm::mix(from.eye, to.eye, fraction),
          .turn = from.turn + fraction * std::remainder(to.turn - from.turn, 2.0f * pi),
          .pitch = mix(from.pitch, to.pitch),
          .vertical_fov = mix(from.vertical_fov, to.vertical_fov)};
}

Sight sight(const Pose& pose, const Space& space, float aspect, float x, float y) {
  const auto a = axes(pose, space);
  const float tangent = tangent_of_half(pose);
  return {pose.eye, glm::normalize(a.ahead + x * aspect * tangent * a.right + y * tangent * a.up)};
}

Mat4 projection(const Pose& pose, const Space& space, const Bounds& box, float aspect, const Tile& tile,
                float empty) {
  const auto a = axes(pose, space);
  const float size = std::max(glm::length(box.size()), 1e-6f);
  const float outside = glm::length(glm::max(Vec3(0.0f), glm::max(box.low - pose.eye, pose.eye - box.high)));
  const float far = 1.01f * (glm::length(pose.eye - box.center()) + 0.5f * size);
  // 24 bits of depth support a ratio of ten thousand, with details of a millimetre in a room of ten metres,
  // and of a tenth of one where nothing is near.
  const float near = std::max({0.5f * outside, far * 1e-4f, std::min(0.25f * empty, far * 1e-3f)});
  const float h = near * tangent_of_half(pose), w = h * aspect;
  return glm::frustum(w * tile.left, w * tile.right, h * tile.bottom, h * tile.top, near, far) *
         glm::lookAt(pose.eye, pose.eye + a.ahead, a.up);
}

}  // namespace luxel
