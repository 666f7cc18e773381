// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/y_up.h"

#include <cmath>

#include <fmt/format.h>

#include "luxel/core/error.h"

namespace luxel {

std::vector<double> turn_to_y_up(const Vec3& up) {
  const auto length = glm::length(Vec3d(up));
  if (!(length > 0.0) || !std::isfinite(length))
    throw InputError(fmt::format("the direction upwards must be a vector of some length, but it is {} {} {}",
                                 up.x, up.y, up.z));
  const auto u = Vec3d(up) / length;
  if (u.y >= 1.0) return {};
  const auto axis = glm::cross(u, Vec3d(0.0, 1.0, 0.0));
  const auto w = 1.0 + u.y;
  const auto norm = std::sqrt(glm::dot(axis, axis) + w * w);
  if (norm < 1e-6) return {1.0, 0.0, 0.0, 0.0};  // upside down: half a turn about any level axis
  return {axis.x / norm, axis.y / norm, axis.z / norm, w / norm};
}

void turn_node_y_up(Json& node, const Vec3& up, const Vec3d& origin) {
  const auto rotation = turn_to_y_up(up);
  if (!rotation.empty()) node["rotation"] = rotation;
  if (origin == Vec3d(0.0)) return;
  const auto at = turned(rotation, origin);
  node["translation"] = {at.x, at.y, at.z};
}

Vec3d turned(const std::vector<double>& rotation, const Vec3d& p) {
  if (rotation.empty()) return p;
  const Vec3d axis(rotation[0], rotation[1], rotation[2]);
  const auto t = 2.0 * glm::cross(axis, p);
  return p + rotation[3] * t + glm::cross(axis, t);
}

}  // namespace luxel
