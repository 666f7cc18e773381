// SPDX-License-Identifier: Apache-2.0
#include "luxel/trace/point_sight.h"

#include <algorithm>
#include <limits>
#include <numbers>

#include "luxel/core/trig.h"
#include "luxel/core/warp.h"
#include "luxel/photometry/near_opening.h"
#include "luxel/photometry/opening.h"

namespace luxel {
namespace {

constexpr double nearest = 1e-6;  // m

// Intensity in a direction, relative to the largest.
double fading(const PointLight& light, const Vec3d& towards_point) {
  if (light.kind == PointLightKind::luminaire) {
    const auto& intensity = light.photometry->intensity;
    return intensity.maximum() > 0.0 ? intensity.at(in_local_axes(light, towards_point)) / intensity.maximum()
                                     : 0.0;
  }
  if (light.kind != PointLightKind::spot) return 1.0;
  const auto cosine = glm::dot(Vec3d(light.direction), towards_point);
  const double inner = light.cos_inner, outer = light.cos_outer;
  const auto fraction = std::clamp((cosine - outer) / (inner - outer), 0.0, 1.0);
  return fraction * fraction;
}

float shortly_before(double distance) {
  return static_cast<float>(std::max(0.5 * distance, distance - recess));
}

PointSight sight_from(const PointLight& light, const Vec3d& position, const Vec3d& point,
                      const Vec3d& normal) {
  PointSight sight;
  if (light.kind == PointLightKind::directional) {
    sight.direction = -Vec3d(light.direction);
    sight.distance = std::numeric_limits<float>::infinity();
    sight.irradiance = std::max(0.0, glm::dot(sight.direction, normal));
    return sight;
  }
  const auto way = position - point;
  const auto distance = std::max(nearest, glm::length(way));
  sight.direction = way / distance;
  sight.distance =
      light.kind == PointLightKind::luminaire ? shortly_before(distance) : static_cast<float>(distance);
  const auto cosine = glm::dot(sight.direction, normal);
  if (!(cosine > 0.0)) return sight;
  sight.irradiance = cosine / (distance * distance) * fading(light, -sight.direction);
  return sight;
}

}  // namespace

PointSight sight_of(const PointLight& light, const Vec3d& point, const Vec3d& normal) {
  return sight_from(light, Vec3d(light.position), point, normal);
}

namespace {

// A direction within the cone of the sun's disc, even in solid angle.
PointSight sight_of_disc(const PointLight& light, const Vec3d& normal, const std::array<double, 2>& u) {
  const auto half = sin_cos(0.5 * static_cast<double>(light.angular_radius)).sine;
  const auto away = u[0] * 2.0 * half * half;  // 1 - cosine
  const auto sine = std::sqrt(away * (2.0 - away));
  const auto turn = sin_cos(2.0 * std::numbers::pi * u[1]);
  const Frame frame(-light.direction);
  PointSight sight;
  sight.direction = glm::normalize(
      Vec3d(frame.to_world(Vec3(static_cast<float>(sine * turn.cosine), static_cast<float>(sine * turn.sine),
                                static_cast<float>(1.0 - away)))));
  sight.distance = std::numeric_limits<float>::infinity();
  sight.irradiance = std::max(0.0, glm::dot(sight.direction, normal));
  return sight;
}

// Chooses a point of a luminaire's opening that lights the receiver, m in the scene's axes.
OpeningPoint choose_point(const PointLight& light, const Vec3d& receiver, const std::array<double, 2>& u) {
  const auto& opening = light.photometry->opening;
  const auto way = receiver - Vec3d(light.position);
  if (glm::dot(way, way) < glm::dot(opening.size, opening.size))
    if (const auto local = in_local_axes(light, way); is_close_to(opening, local))
      return sample_opening_from(opening, local, u);
  return {sample_opening(opening, u)};
}

}  // namespace

PointSight sight_of(const PointLight& light, const Vec3d& point, const Vec3d& normal,
                    const std::array<double, 2>& u) {
  if (light.kind == PointLightKind::directional && is_extended(light)) return sight_of_disc(light, normal, u);
  if (!has_opening(light)) return sight_from(light, Vec3d(light.position), point, normal);
  const auto& opening = light.photometry->opening;
  const auto chosen = choose_point(light, point, u);
  auto sight = sight_from(light, from_local_axes(light, chosen.at), point, normal);
  sight.irradiance *= chosen.weight;
  if (!(sight.irradiance > 0.0)) return sight;
  const bool is_body = opening.size.x > 0.0 && opening.size.y > 0.0 && opening.size.z > 0.0;
  const bool is_near = sight.distance < glm::length(opening.size) + 2.0 * recess;
  if (!is_body && !is_near) return sight;
  const auto from = in_local_axes(light, point - Vec3d(light.position));
  if (is_near && holds(opening, from, recess)) return {};
  if (is_body)
    if (const auto entry = meet_opening(opening, from, in_local_axes(light, sight.direction)))
      sight.distance = shortly_before(*entry);
  return sight;
}

bool has_opening(const PointLight& light) {
  return light.kind == PointLightKind::luminaire && light.photometry->opening.shape != OpeningShape::point;
}

bool is_extended(const PointLight& light) {
  return has_opening(light) || (light.kind == PointLightKind::directional && light.angular_radius > 0.0f);
}

double extent_of(const PointLight& light) {
  return has_opening(light) ? bounding_radius(light.photometry->opening) : 0.0;
}

double relative_intensity(const PointLight& light, const Vec3d& point) {
  return fading(light, glm::normalize(point - Vec3d(light.position)));
}

double zone_intensity(const PointLight& light, const Vec3d& point) {
  if (light.kind != PointLightKind::luminaire) return relative_intensity(light, point);
  const auto& intensity = light.photometry->intensity;
  const auto z = -glm::dot(glm::normalize(point - Vec3d(light.position)), Vec3d(light.direction));
  return intensity.maximum() > 0.0 ? intensity.zone_maximum(z) / intensity.maximum() : 0.0;
}

Vec3d in_local_axes(const PointLight& light, const Vec3d& v) {
  return {glm::dot(v, Vec3d(light.local_x)), glm::dot(v, Vec3d(light.local_y)),
          -glm::dot(v, Vec3d(light.direction))};
}

Vec3d from_local_axes(const PointLight& light, const Vec3d& at) {
  return Vec3d(light.position) + at.x * Vec3d(light.local_x) + at.y * Vec3d(light.local_y) -
         at.z * Vec3d(light.direction);
}

double relative_radiance(const PointLight& light, const LuminousOpening& opening, const Vec3d& to_eye) {
  const auto area = projected_area(opening, in_local_axes(light, to_eye));
  return area > 0.0 ? fading(light, to_eye) / area : 0.0;
}

double emitting_angle(const PointLight& light) {
  if (light.kind == PointLightKind::directional) return 0.0;
  if (light.kind == PointLightKind::point) return 4.0 * std::numbers::pi;
  if (light.kind == PointLightKind::luminaire) {
    const auto& intensity = light.photometry->intensity;
    return intensity.maximum() > 0.0 ? intensity.linear_flux() / intensity.maximum() : 0.0;
  }
  // The square of a fraction that rises linearly with the cosine has the mean 1/3.
  const double inner = light.cos_inner, outer = light.cos_outer;
  return 2.0 * std::numbers::pi * ((1.0 - inner) + (inner - outer) / 3.0);
}

}  // namespace luxel
