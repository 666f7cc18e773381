// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/set_daylight.h"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/core/trig.h"
#include "luxel/import/sky_picture.h"
#include "luxel/photometry/perez_sky.h"
#include "luxel/photometry/sky_integrals.h"
#include "luxel/photometry/sky_model.h"
#include "luxel/scene/luminous_efficacy.h"
#include "luxel/scene/up_axis.h"

namespace luxel {
namespace {

constexpr int subdivision = 8;  // piecewise constant skies are then right to 0.05 % through small windows
constexpr double sun_radius = 0.5 * 0.533;           // degrees
constexpr double extraterrestrial_normal = 127'500;  // lx

double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }

// Local axes: east, north, zenith.
Vec3d towards(const Daylight::Sun& sun) {
  const auto e = sin_cos(radians(sun.elevation)), a = sin_cos(radians(sun.azimuth));
  return {e.cosine * a.sine, e.cosine * a.cosine, e.sine};
}

void check(const Daylight& d, const Scene& scene) {
  const auto require = [&](bool holds, const char* what, double found) {
    if (!holds) throw InputError(scene.source, fmt::format("daylight: expected {}, found {}", what, found));
  };
  require(d.illuminance >= 0.0 && d.illuminance <= 1e9, "an illuminance of the sky from 0 to 1e9 lx",
          d.illuminance);
  require(d.cie_type >= 1 && d.cie_type <= sky_types, "a CIE type from 1 to 16", d.cie_type);
  require(d.albedo >= 0.0 && d.albedo <= 1.0, "an albedo of the ground from 0 to 1", d.albedo);
  require(std::isfinite(d.north), "a finite angle of north", d.north);
  require(d.direct_normal >= 0.0 && d.direct_normal <= 1e6, "a direct irradiance from 0 to 1e6 W/m²",
          d.direct_normal);
  require(d.diffuse_horizontal >= 0.0 && d.diffuse_horizontal <= 1e6,
          "a diffuse irradiance from 0 to 1e6 W/m²", d.diffuse_horizontal);
  if (d.sun_illuminance)
    require(*d.sun_illuminance >= 0.0 && *d.sun_illuminance <= 1e9,
            "an illuminance by the sun from 0 to 1e9 lx", *d.sun_illuminance);
  if (!d.sun) return;
  require(d.sun->elevation >= -90.0 && d.sun->elevation <= 90.0,
          "an elevation of the sun from -90 to 90 degrees", d.sun->elevation);
  require(std::isfinite(d.sun->azimuth), "a finite azimuth of the sun", d.sun->azimuth);
}

void add_sun(const Vec3d& towards_sun, double lux, double radius, const SkyPatches& patches, Scene& scene) {
  PointLight sun;
  sun.name = "sun";
  sun.kind = PointLightKind::directional;
  sun.direction = Vec3(-patches.in_scene_axes(towards_sun));
  sun.intensity = Vec3(static_cast<float>(lux / luminous_efficacy));
  sun.angular_radius = static_cast<float>(radians(radius));
  scene.point_lights.push_back(std::move(sun));
}

// The luminances of a sky model, and the light of the sun.
struct Outside {
  SkyModel model;
  double sky = 0.0;  // of the ground, lx
  double sun = 0.0;  // of a plane that faces it, lx
};

Outside outside_of(const Daylight& d, const Vec3d& sun) {
  Outside outside{{}, d.illuminance, d.sun_illuminance.value_or(0.0)};
  if (d.sky == Daylight::Sky::cie) {
    outside.model = SkyModel::cie(d.cie_type, sun);
    if (d.sun && !d.sun_illuminance) outside.sun = cie_sun_illuminance(d.cie_type, d.sun->elevation);
  } else if (d.sky == Daylight::Sky::perez) {
    const auto perez = perez_sky({d.direct_normal, d.diffuse_horizontal, d.dew_point, d.orbit_factor}, sun);
    outside.model = perez.model;
    if (d.illuminance == 0.0) outside.sky = perez.diffuse_illuminance;
    if (!d.sun_illuminance) outside.sun = perez.direct_normal_illuminance;
  }
  if (!d.sun || !(sun.z > 0.0)) outside.sun = 0.0;
  return outside;
}

void set_model(const Daylight& d, const Vec3d& up, Scene& scene) {
  const auto sun = d.sun ? towards(*d.sun) : Vec3d(0.0, 0.0, 1.0);
  const auto outside = outside_of(d, sun);
  const SkyPatches patches(d.sky == Daylight::Sky::uniform ? 0 : subdivision, up, north_of(up, d.north));
  if (outside.sun > 0.0) add_sun(sun, outside.sun, sun_radius, patches, scene);
  if (!(outside.sky > 0.0) && !(outside.sun > 0.0 && d.albedo > 0.0)) return;
  scene.sky_patches = patches;
  const SkyLevel level{outside.sky, outside.sun * std::max(0.0, sun.z), d.albedo};
  for (const auto luminance : sky_patch_luminances(outside.model, patches, level))
    scene.sky_radiance.emplace_back(static_cast<float>(luminance / luminous_efficacy));
}

void set_picture(const Daylight& d, const Vec3d& up, Scene& scene) {
  const SkyPatches patches(subdivision, up, north_of(up, d.north), LowerHalf::mirrored);
  auto picture = read_sky_picture(d.picture, patches, d.illuminance);
  scene.sky_patches = patches;
  scene.sky_radiance = std::move(picture.radiance);
  for (const auto& spot : picture.spots) {
    add_sun(spot.towards, luminous_efficacy, spot.angular_radius * 180.0 / std::numbers::pi, patches, scene);
    scene.point_lights.back().intensity = spot.irradiance;
  }
}

}  // namespace

Vec3d north_of(const Vec3d& up, double degrees) {
  Vec3d north = std::fabs(up.y) > std::fabs(up.z) ? Vec3d(0.0, 0.0, -1.0) : Vec3d(0.0, 1.0, 0.0);
  north = glm::normalize(north - glm::dot(north, up) * up);
  const auto clockwise = glm::cross(north, up);  // a right angle on, seen from above
  const auto turn = sin_cos(radians(degrees));
  return glm::normalize(turn.cosine * north + turn.sine * clockwise);
}

double cie_sun_illuminance(int cie_type, double elevation) {
  if (cie_type < 7 || cie_type > 15 || !(elevation > 0.0)) return 0.0;
  const auto air_mass =
      1.0 / (sin_cos(radians(elevation)).sine + 0.50572 * std::pow(elevation + 6.07995, -1.6364));
  return extraterrestrial_normal * std::exp(-(cie_type > 10 ? 0.21 : 0.80) * air_mass);
}

void set_daylight(const Daylight& daylight, const Vec3& up, Scene& scene) {
  check(daylight, scene);
  const Vec3d axis(glm::normalize(Vec3d(up_of_scene(scene, up))));
  if (daylight.sky == Daylight::Sky::picture)
    set_picture(daylight, axis, scene);
  else
    set_model(daylight, axis, scene);
}

}  // namespace luxel
