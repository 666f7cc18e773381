// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/probe_place.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "luxel/core/bounds.h"
#include "luxel/core/warp.h"
#include "luxel/render/surface_point.h"

namespace luxel {
namespace {

// Returns whether the back of a patch receives more light than its front, summed over bands.
bool back_is_brighter(const Solution& solution, std::size_t patch) {
  const auto bands = static_cast<std::ptrdiff_t>(solution.bands.size());
  const auto sum = [&](const std::vector<float>& irradiance) {
    const auto first = irradiance.begin() + static_cast<std::ptrdiff_t>(patch) * bands;
    return std::accumulate(first, first + bands, 0.0);
  };
  return sum(solution.irradiance.back) > sum(solution.irradiance.front);
}

}  // namespace

float surface_tolerance(const PatchSet& patches) {
  constexpr float max_tolerance = 1e-3f;         // m: coordinates are often rounded to millimetres
  constexpr float fraction_of_diagonal = 1e-4f;  // for small scenes
  Bounds box;
  for (const auto& v : patches.vertices) box.add(v);
  if (box.empty()) return max_tolerance;
  return std::min(max_tolerance, fraction_of_diagonal * glm::length(box.size()));
}

ProbeOrigin origin_of(const PatchSet& patches, const Solution& solution, const Tracer& tracer,
                      const ProbePoint& point, float tolerance) {
  ProbeOrigin origin{{point.position, point.normal, 0.0f}, false};
  // A surface within the tolerance of the point along this direction, before or behind it.
  const auto surface_along = [&](const Vec3& direction) {
    const auto hit = tracer.nearest({origin.rays.position - tolerance * direction, direction});
    return hit && hit.distance <= 2.0f * tolerance ? hit : Hit{};
  };
  if (const auto hit = surface_along(-point.normal)) {
    const bool back = glm::dot(patches.normal[hit.patch], point.normal) < 0.0f;
    const auto lift = origin_lift(patches.points(hit.patch));
    origin = {{surface_point(patches, hit.patch, back, {hit.u, hit.v}).position, point.normal, lift}, true};
  }
  constexpr float max_lean =
      0.7f;  // cosine of the angle between normals; below: the surface is beside the point
  const Frame frame(point.normal);
  for (const auto& aside : {frame.s, -frame.s, frame.t, -frame.t})
    if (const auto wall = surface_along(aside)) {
      const bool back = back_is_brighter(solution, wall.patch);
      const auto normal = patches.normal_of(SideId(wall.patch, back));
      if (std::abs(glm::dot(normal, point.normal)) > max_lean) continue;
      const auto height = glm::dot(normal, origin.rays.position - patches.points(wall.patch)[0]);
      origin.rays.position += (tolerance - height) * normal;
    }
  return origin;
}

}  // namespace luxel
