// SPDX-License-Identifier: Apache-2.0
#include "luxel/runs/daylight_settings.h"

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/photometry/sky_model.h"

namespace luxel {
namespace {

constexpr float max_radiance = 1e9f;
constexpr double max_lux = 1e9;

std::optional<Vec3> radiance_of(const std::string& text) {
  const auto grey = parse_number(text);
  const auto three = parse_three(text);
  const auto radiance = grey    ? std::optional(Vec3(*grey))
                        : three ? std::optional(Vec3(*three))
                                : std::nullopt;
  if (radiance && is_finite(*radiance) && *radiance == glm::clamp(*radiance, 0.0f, max_radiance))
    return radiance;
  return std::nullopt;
}

bool is_cie(const std::string& text) {
  for (int type = 1; type <= sky_types; ++type)
    if (text == fmt::format("cie:{}", type)) return true;
  return false;
}

bool is_picture(const std::string& text) {
  return text.ends_with(".hdr") || text.ends_with(".exr") || text.ends_with(".HDR") || text.ends_with(".EXR");
}

std::string checked_sky(const std::string& text) {
  if (text == "auto" || text == "none" || text == "uniform" || text == "perez" || is_cie(text) ||
      is_picture(text))
    return text;
  if (const auto radiance = radiance_of(text)) return *radiance == Vec3(0.0f) ? "none" : text;
  throw UsageError(fmt::format(
      "--sky: expected auto, none, uniform, cie:1 to cie:{}, perez, a picture (.hdr, .exr), or a radiance: a "
      "number from 0 to {:g}, or three such as 0.8,0.9,1, not '{}'",
      sky_types, max_radiance, text));
}

}  // namespace

Vec3 DaylightSettings::even_radiance() const { return radiance_of(sky).value_or(Vec3(0.0f)); }

std::string DaylightSettings::kind() const {
  if (sky == "uniform" || sky == "perez" || is_cie(sky)) return sky;
  if (!has_sun()) return {};
  if (sky == "auto") return outside.weather.empty() ? "cie:12" : "perez";
  return sky == "none" ? "uniform" : std::string();
}

std::optional<Daylight> DaylightSettings::daylight() const {
  Daylight d;
  d.albedo = outside.albedo;
  d.north = north;
  d.illuminance = outside.sky_illuminance.value_or(default_sky_illuminance);
  if (is_picture(sky)) {
    d.sky = Daylight::Sky::picture;
    d.picture = sky;
    return d;
  }
  if (kind().empty()) return std::nullopt;
  const auto light = outside.daylight(kind());
  d.illuminance = light.horizontal_illuminance;
  if (light.sun) d.sun = Daylight::Sun{light.sun->elevation, light.sun->azimuth};
  d.sun_illuminance = light.direct_normal_illuminance;
  if (sun_illuminance != "auto") d.sun_illuminance = parse_number(sun_illuminance);
  if (light.cie_type > 0) {
    d.sky = Daylight::Sky::cie;
    d.cie_type = light.cie_type;
  }
  if (light.kind == "perez") {
    d.sky = Daylight::Sky::perez;
    d.direct_normal = outside.direct_normal.value_or(0.0);
    d.diffuse_horizontal = outside.diffuse_horizontal.value_or(0.0);
    d.dew_point = outside.dew_point.value_or(d.dew_point);
    d.orbit_factor = light.sun->orbit_factor();
  }
  if (light.kind == "perez" && light.hour) {
    d.direct_normal = light.hour->record().direct_normal.value_or(0.0);
    d.diffuse_horizontal = light.hour->record().diffuse_horizontal.value_or(0.0);
    d.dew_point = mean_dew_point(light.hour->weather, light.hour->index);
  }
  if (sky == "none") {  // the sun alone
    d.illuminance = 0.0;
    d.albedo = 0.0;
  }
  return d;
}

void DaylightSettings::check() const {
  const auto refuse = [](const char* text) { throw UsageError(text); };
  const bool has_kind = !kind().empty() || is_picture(sky);
  if (outside.sky_illuminance && !has_kind)
    refuse(
        "--sky-illuminance needs --sky uniform, cie:N, perez or a picture: a sky given by its radiance has "
        "its "
        "own");
  if (has_sun() && is_picture(sky))
    refuse("--sun, --date and --weather do not go with a picture of the sky, which has its own sun");
  if (has_sun() && !has_kind)
    refuse(
        "--sun, --date and --weather need --sky none, uniform, cie:N or perez: a sky given by its radiance "
        "has "
        "no sun");
  if (sun_illuminance != "auto" && !has_sun()) refuse("--sun-illuminance needs --sun, --date or --weather");
  daylight();
}

void DaylightSettings::declare(OptionSet& set) {
  set.heading("Light");
  Declaration of_sky{
      "sky", "KIND",
      "the sky around the scene; it enters through windows. uniform; cie:1 to cie:16: a CIE standard general "
      "sky, 16 the traditional overcast one; perez: the all-weather sky of irradiances or of a weather file; "
      "FILE.hdr or FILE.exr: an equirectangular picture; a number or red,green,blue: an even radiance, "
      "W/(m² sr); auto: cie:12 or perez if there is a sun, none if the scene has a lamp, otherwise daylight, "
      "or "
      "a luminaire in a closed room; none: no sky, and no light is added",
      [this](const std::string& text) { sky = checked_sky(text); }, [this] { return sky; }};
  of_sky.endings = ".hdr .exr";
  set.add(std::move(of_sky));
  outside.declare_sky(set);
  outside.declare_sun(set);
  set.add(
      {"sun-illuminance", "lx",
       "illuminance by the sun of a plane that faces it; auto: that of perez or of the weather file, else by "
       "the sun's elevation under cie:7 to cie:15, none under other skies",
       [this](const std::string& text) {
         const auto value = parse_number(text);
         if (text != "auto" && (!value || !(*value >= 0.0f && *value <= max_lux)))
           throw UsageError(fmt::format("--sun-illuminance: expected auto or lux from 0 to {:g}, not '{}'",
                                        max_lux, text));
         sun_illuminance = text;
       },
       [this] { return sun_illuminance; }});
  set.add_number("north", "degrees", north, -360.0, 360.0,
                 "where north is: clockwise seen from above, from +Y where Z is up, from -Z where Y is up");
  set.heading("Light");
}

}  // namespace luxel
