// SPDX-License-Identifier: Apache-2.0
#include "luxel/scene/scene.h"

#include <algorithm>
#include <utility>

namespace luxel {

Bounds bounds(const Scene& scene) {
  Bounds box;
  for (const auto& triangle : scene.triangles)
    for (const auto corner : triangle) box.add(scene.positions[corner]);
  return box;
}

bool has_sky(const Scene& scene) {
  return scene.sky != Vec3(0.0f) || !scene.sky_spectrum.empty() ||
         std::any_of(scene.sky_radiance.begin(), scene.sky_radiance.end(),
                     [](const Vec3& radiance) { return radiance != Vec3(0.0f); });
}

bool has_lamp(const Scene& scene) {
  if (!scene.point_lights.empty()) return true;
  return std::any_of(
      scene.triangle_material.begin(), scene.triangle_material.end(),
      [&](MaterialId material) { return scene.materials[static_cast<std::size_t>(material)].is_lamp(); });
}

bool has_light(const Scene& scene) { return has_sky(scene) || has_lamp(scene); }

void turn_triangle(Scene& scene, std::size_t triangle) {
  std::swap(scene.triangles[triangle][1], scene.triangles[triangle][2]);
  for (auto& set : scene.uv_sets) std::swap(set[triangle][1], set[triangle][2]);
  if (!scene.corner_colours.empty())
    std::swap(scene.corner_colours[triangle][1], scene.corner_colours[triangle][2]);
}

}  // namespace luxel
