// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "luxel/lamps/choose_portals.h"
#include "luxel/patch/make_patches.h"

#include "support/window_rooms.h"

namespace luxel::truth {

// Makes a material of a scene a pane of glass.
inline void make_pane(Scene& scene, const std::string& name, const Vec3& transmittance) {
  for (auto& material : scene.materials) {
    if (material.name != name) continue;
    material.opaque = false;
    material.transmittance = transmittance;
  }
}

// A sheet of 0.5 x 0.5 m in the hole of window_room(), or as far from it, of the material last named.
inline SceneBuilder& add_sheet(SceneBuilder& builder, float depth = 0.0f) {
  return builder.quad({0.75f, depth, 0.5f}, {1.25f, depth, 0.5f}, {1.25f, depth, 1.0f}, {0.75f, depth, 1.0f});
}

enum class Glazing { sheet, box, doubled };

// The room with a window, without reflections, and glass in it.
inline Scene glazed_room(Glazing glazing, const Vec3& transmittance, float reflectance = 0.0f) {
  auto builder = window_room();
  builder.material("glass", 0.1f, 0.0f);
  if (glazing == Glazing::box)
    add_box(builder, {0.6f, -0.02f, 0.35f}, {1.4f, -0.014f, 1.15f});
  else
    add_sheet(builder);
  if (glazing == Glazing::doubled)
    builder.quad({0.6f, -0.016f, 0.35f}, {1.4f, -0.016f, 0.35f}, {1.4f, -0.016f, 1.15f},
                 {0.6f, -0.016f, 1.15f});
  auto scene = under_sky(builder);
  for (auto& material : scene.materials) material.reflectance = Vec3(reflectance);
  make_pane(scene, "glass", transmittance);
  return scene;
}

inline PatchSet with_portals(const Scene& scene, bool portals, float max_edge = 0.5f) {
  auto patches = make_patches(scene, {.max_edge = max_edge});
  if (portals) set_portals(scene, patches, Context(2));
  return patches;
}

// A room with a lamp, parted by a sheet of glass; nothing escapes.
inline Scene parted_room(const Vec3& transmittance) {
  SceneBuilder b;
  b.material("walls", 0.7f, 0.0f)
      .quad({0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0})
      .quad({0, 0, 0}, {0, 0, 1}, {2, 0, 1}, {2, 0, 0})
      .quad({0, 1, 0}, {2, 1, 0}, {2, 1, 1}, {0, 1, 1})
      .quad({0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1})
      .quad({2, 0, 0}, {2, 0, 1}, {2, 1, 1}, {2, 1, 0});
  b.material("ceiling", 0.7f, 0.0f).quad({1, 0, 1}, {1, 1, 1}, {2, 1, 1}, {2, 0, 1});
  b.material("lamp", 0.7f, 1.0f).quad({0, 0, 1}, {0, 1, 1}, {1, 1, 1}, {1, 0, 1});
  b.material("glass", 0.1f, 0.0f).quad({1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0, 1});
  auto scene = b.scene();
  make_pane(scene, "glass", transmittance);
  return scene;
}

// Irradiance at a point of what shines evenly through a rectangle corner + u * along + v * across, u and v in
// [0, 1], W/m², by the midpoints of steps x steps cells; radiance(direction, cosine at the rectangle):
// W/(m² sr). along and across are at right angles.
template <typename Radiance>
double irradiance_through(const Vec3d& point, const Vec3d& normal, const std::array<Vec3d, 3>& rectangle,
                          const Radiance& radiance, int steps = 500) {
  const auto& [corner, along, across] = rectangle;
  const auto area = glm::cross(along, across);
  const auto axis = glm::normalize(area);
  double sum = 0.0;
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j) {
      const auto way = corner + (i + 0.5) / steps * along + (j + 0.5) / steps * across - point;
      const auto direction = glm::normalize(way);
      const auto cosine = std::fabs(glm::dot(axis, direction));
      const auto here = std::max(0.0, glm::dot(normal, direction));
      sum += here * cosine / glm::dot(way, way) * radiance(direction, cosine);
    }
  return sum * glm::length(area) / (steps * steps);
}

// The hole of window_room().
inline std::array<Vec3d, 3> window_rectangle() {
  return {Vec3d(0.75, 0.0, 0.5), Vec3d(0.5, 0.0, 0.0), Vec3d(0.0, 0.0, 0.5)};
}

}  // namespace luxel::truth
