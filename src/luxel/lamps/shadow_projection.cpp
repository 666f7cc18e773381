// SPDX-License-Identifier: Apache-2.0
#include "luxel/lamps/shadow_projection.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace luxel {
namespace {

constexpr double min_sine =
    0.02;  // sine of the angle between a sun and the plane: below it there is little light
constexpr double below_lamp = 0.999;  // of the light's height: beyond it a shadow is a thousand times as long

}  // namespace

ShadowProjection::ShadowProjection(const PointLight& light, const FlatTriangle& plane)
    : light_(light), plane_(plane) {
  if (light.kind == PointLightKind::directional) {
    const auto sine = -glm::dot(plane.normal, Vec3d(light.direction));
    if (std::fabs(sine) > min_sine) side_ = sine > 0.0 ? 1.0 : -1.0;
    light_height_ = std::numeric_limits<double>::infinity();
    return;
  }
  const auto above = plane.height(Vec3d(light.position));
  if (above != 0.0) side_ = above > 0.0 ? 1.0 : -1.0;
  light_height_ = std::fabs(above);
}

bool ShadowProjection::is_between(const Vec3d& point, double slack) const {
  return height(point) > slack && height(point) < below_lamp * light_height_;
}

std::optional<std::array<Vec3d, 2>> ShadowProjection::shadow(const OutlineEdge& edge, double slack) const {
  auto from = height(edge.a), to = height(edge.b);
  if (std::fabs(from) <= slack) from = 0.0;
  if (std::fabs(to) <= slack) to = 0.0;
  const auto highest = below_lamp * light_height_;
  if (std::max(from, to) <= 0.0 || std::min(from, to) >= highest) return std::nullopt;
  double begin = 0.0, end = 1.0;
  if (from < 0.0) begin = from / (from - to);
  if (to < 0.0) end = from / (from - to);
  if (from > highest) begin = (from - highest) / (from - to);
  if (to > highest) end = (from - highest) / (from - to);
  const auto along = edge.b - edge.a;
  return std::array{project(edge.a + begin * along), project(edge.a + end * along)};
}

Vec3d ShadowProjection::project(const Vec3d& point) const {
  const auto above = plane_.height(point);
  Vec3d shadow;
  if (light_.kind == PointLightKind::directional) {
    const Vec3d way(light_.direction);
    shadow = point - above / glm::dot(plane_.normal, way) * way;
  } else {
    const Vec3d lamp(light_.position);
    const auto full = plane_.height(lamp);
    shadow = lamp + full / (full - above) * (point - lamp);
  }
  return plane_.foot_point(shadow);
}

}  // namespace luxel
