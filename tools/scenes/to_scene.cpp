// SPDX-License-Identifier: Apache-2.0
#include "scenes/to_scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "luxel/scene/luminous_efficacy.h"

namespace luxel::scenes {
namespace {

// Materials are numbered as their paints first occur.
class Materials {
 public:
  explicit Materials(Scene& scene) : scene_(scene), number_(static_cast<std::size_t>(Paint::count), -1) {}

  MaterialId of(Paint paint) {
    auto& number = number_[static_cast<std::size_t>(paint)];
    if (number < 0) {
      number = static_cast<int>(scene_.materials.size());
      const auto& pigment = palette()[static_cast<std::size_t>(paint)];
      scene_.materials.push_back(
          {pigment.name, Vec3(pigment.reflectance), pi * Vec3(pigment.radiance), true});
    }
    return static_cast<MaterialId>(number);
  }

 private:
  Scene& scene_;
  std::vector<int> number_;
};

PointLight to_point_light(const PunctualLight& light) {
  auto result = PointLight{};
  result.name = light.name;
  result.kind = light.kind == PunctualLight::sun     ? PointLightKind::directional
                : light.kind == PunctualLight::point ? PointLightKind::point
                                                     : PointLightKind::spot;
  result.position = Vec3(light.position);
  if (light.kind != PunctualLight::point) result.direction = Vec3(glm::normalize(light.direction));
  result.intensity = Vec3(light.colour * (light.intensity / luminous_efficacy));
  if (light.kind == PunctualLight::spot) {
    result.cos_inner = static_cast<float>(std::cos(glm::radians(0.6 * light.outer_degrees)));
    result.cos_outer = static_cast<float>(std::cos(glm::radians(light.outer_degrees)));
  }
  return result;
}

}  // namespace

Scene to_scene(const MadeScene& made, const std::string& name) {
  auto scene = Scene{};
  scene.source = name;
  scene.up = {0.0f, 1.0f, 0.0f};
  auto materials = Materials(scene);
  for (const auto& object : made.objects) {
    const auto first = static_cast<std::uint32_t>(scene.positions.size());
    scene.positions.insert(scene.positions.end(), object.mesh.points.begin(), object.mesh.points.end());
    auto triangles = object.mesh.triangles;
    std::stable_sort(triangles.begin(), triangles.end(),
                     [](const Triangle& a, const Triangle& b) { return a.paint < b.paint; });
    for (const auto& [corners, paint] : triangles) {
      scene.triangles.push_back({first + corners[0], first + corners[1], first + corners[2]});
      scene.triangle_material.push_back(materials.of(paint));
      scene.triangle_line.push_back(0);
      scene.triangle_group.push_back(static_cast<std::uint32_t>(scene.groups.size()));
    }
    scene.groups.push_back(object.name);
  }
  for (const auto& light : made.lights) scene.point_lights.push_back(to_point_light(light));
  for (const auto& view : made.views) {
    scene.cameras.push_back(
        {Vec3(view.eye), Vec3(view.target), {0.0f, 1.0f, 0.0f}, static_cast<float>(view.vertical_fov)});
  }
  return scene;
}

}  // namespace luxel::scenes
