// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/gltf_lamps.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "luxel/core/trig.h"
#include "luxel/import/gltf_luminaires.h"
#include "luxel/import/name_list.h"
#include "luxel/scene/luminous_efficacy.h"

namespace luxel {
namespace {

constexpr double right_angle = std::numbers::pi / 2.0;

Vec3 intensity_of(const JsonValue& light) {
  constexpr double most = 1e30;
  const auto colour = light["color"].numbers({1.0, 1.0, 1.0});
  const auto intensity = light["intensity"].number(1.0);
  Vec3 watts;
  for (int band = 0; band < 3; ++band) {
    const auto of_band = colour[static_cast<std::size_t>(band)] * intensity;
    if (!(of_band >= 0.0 && of_band <= most))
      light.refuse(fmt::format("expected colour times intensity of 0 to {:g}, found {}", most, of_band));
    watts[band] = static_cast<float>(of_band / luminous_efficacy);
  }
  return watts;
}

// Some programs write equal angles for a spot with a sharp boundary. The light then fades within a
// thousandth, as in the extension's own formula.
void read_cone(const JsonValue& spot, PointLight& lamp) {
  constexpr double narrowest = 1e-3;
  const auto inner = spot["innerConeAngle"].number(0.0);
  const auto outer = spot["outerConeAngle"].number(0.5 * right_angle);
  if (!(inner >= 0.0 && inner <= outer && outer > 0.0 && outer <= right_angle + narrowest))
    spot.refuse(fmt::format("expected 0 <= innerConeAngle <= outerConeAngle <= {:.6f}, found {} and {}",
                            right_angle, inner, outer));
  const auto cos_inner = sin_cos(inner).cosine;
  const auto cos_outer = std::min(sin_cos(outer).cosine, cos_inner - narrowest);
  lamp.cos_inner = static_cast<float>(cos_inner);
  lamp.cos_outer = static_cast<float>(cos_outer);
}

PointLight lamp_of(const JsonValue& light) {
  PointLight lamp;
  const auto kind = light["type"].text();
  if (kind == "point")
    lamp.kind = PointLightKind::point;
  else if (kind == "spot")
    lamp.kind = PointLightKind::spot;
  else if (kind == "directional")
    lamp.kind = PointLightKind::directional;
  else
    light["type"].refuse(fmt::format("expected point, spot or directional, found '{}'", kind.substr(0, 40)));
  lamp.name = light["name"].text("");
  lamp.intensity = intensity_of(light);
  if (lamp.kind == PointLightKind::spot) read_cone(light["spot"], lamp);
  return lamp;
}

Camera camera_of(const PlacedNode& placed, const JsonValue& perspective, double scale, const Scene& scene) {
  const auto field = perspective["yfov"];
  const auto degrees = field.number() * 180.0 / std::numbers::pi;
  if (!(degrees > 1e-3 && degrees < 179.999))
    field.refuse(fmt::format("expected an angle between 0 and pi, found {}", field.number()));
  Camera camera;
  camera.eye = gltf_place(placed, scale, scene);
  const auto ahead = gltf_axis(placed, Vec3d(0.0, 0.0, -1.0));
  camera.up = gltf_axis(placed, Vec3d(0.0, 1.0, 0.0));
  if (!(glm::length(glm::cross(ahead, camera.up)) > 1e-3f))
    placed.node.refuse("expected a camera whose up is not along its view");
  camera.target = camera.eye +
                  std::max(1.0f, 1e-3f * glm::length(camera.eye)) * ahead;  // distinct from the eye in floats
  camera.vertical_fov = static_cast<float>(degrees);
  camera.aspect = std::max(0.0f, static_cast<float>(perspective["aspectRatio"].number(0.0)));
  return camera;
}

}  // namespace

Vec3 gltf_place(const PlacedNode& placed, double scale, const Scene& scene) {
  const auto at = scale * Vec3d(placed.world[3]);
  if (!(std::abs(at.x) <= farthest && std::abs(at.y) <= farthest && std::abs(at.z) <= farthest))
    placed.node.refuse(fmt::format("it comes to lie beyond {:g} m", farthest));
  return Vec3(at - scene.origin);
}

Vec3 gltf_axis(const PlacedNode& placed, const Vec3d& axis) {
  const auto turned = glm::dmat3(placed.world) * axis;
  const auto length = glm::length(turned);
  if (!(length > 0.0) || !std::isfinite(length))
    placed.node.refuse("expected an axis to look along, found a scale of 0");
  return Vec3(turned / length);
}

void add_lamps(const GltfFile& file, std::span<const PlacedNode> nodes, double scale, Scene& scene) {
  const auto lights = file.root()["extensions"]["KHR_lights_punctual"]["lights"];
  for (const auto& placed : nodes) {
    const auto index = placed.node["extensions"]["KHR_lights_punctual"]["light"];
    if (!index || has_luminaire(placed.node)) continue;
    const auto number = index.whole();
    if (number >= lights.size())
      index.refuse(
          fmt::format("it names lamp {}, but the file has {} (numbered from 0)", number, lights.size()));
    auto lamp = lamp_of(lights[number]);
    lamp.name = placed.node["name"].text(lamp.name);
    if (lamp.name.empty()) lamp.name = fmt::format("node {}", placed.number);
    lamp.position = gltf_place(placed, scale, scene);
    if (lamp.kind != PointLightKind::point) lamp.direction = gltf_axis(placed, Vec3d(0.0, 0.0, -1.0));
    scene.point_lights.push_back(std::move(lamp));
  }
}

void add_cameras(const GltfFile& file, std::span<const PlacedNode> nodes, double scale, Scene& scene,
                 const Context& context) {
  std::size_t without_perspective = 0;
  for (const auto& placed : nodes) {
    if (!placed.node["camera"]) continue;
    const auto camera = file.object(placed.node["camera"], "cameras");
    if (const auto perspective = camera["perspective"])
      scene.cameras.push_back(camera_of(placed, perspective, scale, scene));
    else
      ++without_perspective;
  }
  if (without_perspective > 0)
    context.warn(fmt::format("{}: {} without perspective passed over", scene.source,
                             counted(without_perspective, "camera")));
}

}  // namespace luxel
