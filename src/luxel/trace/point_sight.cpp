// SPDX-License-Identifier: Apache-2.0
#include "luxel/trace/point_sight.h"

#include <algorithm>
#include <limits>
#include <numbers>

namespace luxel {
namespace {

constexpr double nearest = 1e-6;  // m

double fading(const PointLight& light, const Vec3d& towards_point) {
  const auto cosine = glm::dot(Vec3d(light.direction), towards_point);
  const double inner = light.cos_inner, outer = light.cos_outer;
  const auto fraction = std::clamp((cosine - outer) / (inner - outer), 0.0, 1.0);
  return fraction * fraction;
}

}  // namespace

PointSight sight_of(const PointLight& light, const Vec3d& point, const Vec3d& normal) {
  PointSight sight;
  if (light.kind == PointLightKind::directional) {
    sight.direction = -Vec3d(light.direction);
    sight.distance = std::numeric_limits<float>::infinity();
    sight.irradiance = std::max(0.0, glm::dot(sight.direction, normal));
    return sight;
  }
  const auto way = Vec3d(light.position) - point;
  const auto distance = std::max(nearest, glm::length(way));
  sight.direction = way / distance;
  sight.distance = static_cast<float>(distance);
  const auto cosine = glm::dot(sight.direction, normal);
  if (!(cosine > 0.0)) return sight;
  sight.irradiance = cosine / (distance * distance);
  if (light.kind == PointLightKind::spot) sight.irradiance *= fading(light, -sight.direction);
  return sight;
}

double emitting_angle(const PointLight& light) {
  if (light.kind == PointLightKind::directional) return 0.0;
  if (light.kind == PointLightKind::point) return 4.0 * std::numbers::pi;
  // The square of a fraction that rises linearly with the cosine has the mean 1/3.
  const double inner = light.cos_inner, outer = light.cos_outer;
  return 2.0 * std::numbers::pi * ((1.0 - inner) + (inner - outer) / 3.0);
}

}  // namespace luxel
