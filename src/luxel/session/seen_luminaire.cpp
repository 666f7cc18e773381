// SPDX-License-Identifier: Apache-2.0
#include "luxel/session/seen_luminaire.h"

#include "luxel/patch/luminaire_groups.h"
#include "luxel/photometry/luminaire_mesh.h"
#include "luxel/photometry/opening.h"
#include "luxel/trace/point_sight.h"

namespace luxel {
std::optional<SeenLuminaire> seen_luminaire(const PatchSet& patches, const Ray& ray, float distance) {
  const Vec3d origin(ray.origin), direction(ray.direction);
  auto nearest = static_cast<double>(distance) + recess;
  const BandPointLight* found = nullptr;
  for (const auto& lamp : patches.point_lights) {
    const auto& light = lamp.light;
    if (light.kind != PointLightKind::luminaire) continue;
    const auto met =
        meet_opening(shown_opening(light.photometry->opening),
                     in_local_axes(light, origin - Vec3d(light.position)), in_local_axes(light, direction));
    if (!met || !(*met < nearest)) continue;
    nearest = *met;
    found = &lamp;
  }
  if (found == nullptr) return std::nullopt;
  return SeenLuminaire{
      found->light.name, found->light.photometry->file,
      patches.light_groups.empty() ? std::string() : patches.light_groups[found->light_group],
      luminaire_lumens(*found, patches), nearest};
}

}  // namespace luxel
