// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/default_light.h"

#include <numbers>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "luxel/core/warp.h"
#include "luxel/patch/make_patches.h"
#include "luxel/render/ceiling_luminaires.h"
#include "luxel/render/sky_reach.h"
#include "luxel/scene/lamp_names.h"
#include "luxel/scene/luminous_efficacy.h"
#include "luxel/trace/tracer.h"

namespace luxel {
namespace {

constexpr double closed =
    0.01;  // fraction of the surfaces that the sky reaches, below which a room is closed
constexpr double absorbed = 0.5;  // assumed fraction of the light that a surface absorbs
// The sky of a clear day: its illuminance over that of a surface that faces the sun, and its colour, with
// luminance 1.
constexpr double sky_of_sun = 0.12;
constexpr Vec3 sky_blue(0.65f, 1.03f, 1.77f);

Vec3 white(double lux) { return Vec3(static_cast<float>(lux / luminous_efficacy)); }

// up: unit.
void set_sky(const Vec3& up, DefaultSky sky, Scene& scene) {
  const auto radiance = white(default_daylight / std::numbers::pi);
  if (sky == DefaultSky::all_around) {
    scene.sky = radiance;
    return;
  }
  scene.sky_patches = SkyPatches(0, Vec3d(up), Vec3d(Frame(up).s));  // any north: the patches have none
  scene.sky_radiance = {radiance * static_cast<float>(default_albedo), radiance};
}

// The sum over all suns of the illuminance of a surface that faces them, in lm/m² over the luminous efficacy.
double brightness_of_suns(const Scene& scene) {
  double sum = 0.0;
  for (const auto& light : scene.point_lights)
    if (light.kind == PointLightKind::directional)
      sum += lumens(light.intensity.r, light.intensity.g, light.intensity.b) / luminous_efficacy;
  return sum;
}

double area_of(const Scene& scene, std::size_t triangle) {
  const auto& t = scene.triangles[triangle];
  const Vec3d a(scene.positions[t[0]]), b(scene.positions[t[1]]), c(scene.positions[t[2]]);
  return 0.5 * glm::length(glm::cross(b - a, c - a));
}

// lm that give default_lamp_light on average on all surfaces: in a steady state they absorb what lamps emit.
double flux_for(const Scene& scene) {
  double area = 0.0;
  for (std::size_t t = 0; t < scene.triangles.size(); ++t) area += area_of(scene, t);
  return default_lamp_light * absorbed * area;
}

// Lets materials named like lamps emit `flux` lm in total, with the same exitance; returns their names.
std::vector<std::string> light_lamp_materials(Scene& scene, double flux) {
  double area = 0.0;
  std::vector<bool> is_used(scene.materials.size(), false);
  for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
    const auto m = static_cast<std::size_t>(scene.triangle_material[t]);
    if (!is_lamp_name(scene.materials[m].name) || !scene.materials[m].opaque) continue;
    is_used[m] = true;
    area += area_of(scene, t);
  }
  std::vector<std::string> names;
  if (!(area > 0.0)) return names;
  for (std::size_t m = 0; m < is_used.size(); ++m) {
    if (!is_used[m]) continue;
    scene.materials[m].emittance = white(flux / area);
    names.push_back(scene.materials[m].name);
  }
  return names;
}

}  // namespace

DefaultLight add_default_light(Scene& scene, const Context& context, DefaultSky sky) {
  const auto suns = has_sky(scene) ? 0.0 : brightness_of_suns(scene);
  if ((has_light(scene) && !(suns > 0.0)) || scene.triangles.empty()) return {};
  const auto patches = make_patches(scene, {.max_edge = no_max_edge, .contacts = false}, context.quiet());
  const Tracer tracer(patches, context.quiet());
  const bool is_open = sky_reach(patches, tracer, context) >= closed;
  if (suns > 0.0) {
    if (!is_open) return {};
    return {.kind = DefaultLightKind::sun_without_sky,
            .suitable_sky = sky_blue * static_cast<float>(sky_of_sun * suns / std::numbers::pi)};
  }
  if (is_open) {
    set_sky(patches.up, sky, scene);
    return {.kind = DefaultLightKind::daylight};
  }
  const auto flux = flux_for(scene);
  if (auto names = light_lamp_materials(scene, flux); !names.empty())
    return {.kind = DefaultLightKind::lamp_materials, .materials = std::move(names)};
  const auto squares = place_luminaires(patches, tracer, context);
  if (squares.empty()) {
    set_sky(patches.up, sky, scene);
    return {.kind = DefaultLightKind::daylight};
  }
  add_luminaires(squares, white(1.0) * static_cast<float>(flux), scene);
  return {.kind = DefaultLightKind::ceiling_luminaires, .luminaires = squares.size()};
}

std::string DefaultLight::as_text() const {
  switch (kind) {
    case DefaultLightKind::not_needed:
      return {};
    case DefaultLightKind::sun_without_sky:
      return "a sun, and no sky around it: the sky stays black; a blue one suits it";
    case DefaultLightKind::daylight:
      return fmt::format("no lamp in the scene: lit by daylight, a uniform sky of {:.0f} lx on open ground",
                         default_daylight);
    case DefaultLightKind::lamp_materials:
      return fmt::format(
          "no lamp in this closed room: materials named like lamps emit, for about {:.0f} lx: {}",
          default_lamp_light, fmt::join(materials, ", "));
    case DefaultLightKind::ceiling_luminaires:
      return fmt::format(
          "no lamp in this closed room: lit by {} below the ceiling, for about {:.0f} lx",
          luminaires == 1 ? "a square luminaire" : fmt::format("{} square luminaires", luminaires),
          default_lamp_light);
  }
  return {};
}

std::vector<Hint> DefaultLight::hints() const {
  if (kind == DefaultLightKind::not_needed) return {};
  if (kind == DefaultLightKind::sun_without_sky)
    return {
        {Setting::sky, fmt::format("{:.2g},{:.2g},{:.2g}", suitable_sky.r, suitable_sky.g, suitable_sky.b)}};
  return {{Setting::sky, kind == DefaultLightKind::daylight ? "RADIANCE" : "none"}};
}

}  // namespace luxel
