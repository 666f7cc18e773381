// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/visible_luminaires.h"

#include <algorithm>
#include <limits>

#include "luxel/photometry/opening.h"
#include "luxel/trace/point_sight.h"

namespace luxel {
VisibleLuminaires::VisibleLuminaires(const PatchSet& patches, const BandColours& colours) {
  for (const auto& lamp : patches.point_lights) {
    if (!has_opening(lamp.light)) continue;
    const auto radius = extent_of(lamp.light);
    openings_.push_back({&lamp.light, colours.rgb(lamp.intensity), radius * radius});
  }
}

std::optional<SeenOpening> VisibleLuminaires::first(const Ray& ray, float distance) const {
  const Vec3d origin(ray.origin), direction(ray.direction);
  auto nearest = static_cast<double>(distance) + recess;
  std::optional<SeenOpening> seen;
  for (const auto& [light, colour, radius2] : openings_) {
    const auto towards = Vec3d(light->position) - origin;
    const auto along = glm::dot(towards, direction);
    if (glm::dot(towards, towards) - along * along > radius2) continue;
    const auto& opening = light->photometry->opening;
    const auto met = meet_opening(opening, in_local_axes(*light, -towards), in_local_axes(*light, direction));
    if (!met || !(*met < nearest)) continue;
    const auto relative = relative_radiance(*light, opening, -direction);
    if (!(relative > 0.0)) continue;
    nearest = *met;
    seen = {colour * relative, static_cast<float>(*met)};
  }
  return seen;
}

}  // namespace luxel
