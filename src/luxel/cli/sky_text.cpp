// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/sky_text.h"

#include <array>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace luxel {
namespace {

using Json = nlohmann::ordered_json;

// ISO 15469:2004, table 1, in short; 16 is the sky of CIE publication 22.
constexpr std::array<const char*, sky_types> descriptions = {
    "overcast, steep gradation to the zenith",
    "overcast, steep gradation, slightly brighter towards the sun",
    "overcast, moderate gradation",
    "overcast, moderate gradation, slightly brighter towards the sun",
    "uniform",
    "partly cloudy, no gradation to the zenith, slightly brighter towards the sun",
    "partly cloudy, no gradation to the zenith, brighter circumsolar region",
    "partly cloudy, no gradation to the zenith, distinct solar corona",
    "partly cloudy, the sun obscured",
    "partly cloudy, brighter circumsolar region",
    "white-blue, distinct solar corona",
    "clear, low turbidity",
    "clear, polluted",
    "cloudless, turbid, broad solar corona",
    "white-blue, turbid, broad solar corona",
    "traditional overcast"};

std::string line(const char* label, const std::string& text) {
  return fmt::format("  {:<18} {}\n", label, text);
}

std::string title_of(const OutsideLight& light) {
  if (light.cie_type == 16) return "cie:16: CIE traditional overcast sky";
  if (light.cie_type > 0)
    return fmt::format("{}: CIE standard general sky, {}", light.kind,
                       descriptions[static_cast<std::size_t>(light.cie_type - 1)]);
  return light.kind == "perez" ? "perez: all-weather sky" : "uniform: the same luminance everywhere";
}

// lx by the sky.
SkyIlluminances illuminances_of(const OutsideLight& light) {
  auto part = relative_illuminances(light.model);
  const auto scale = light.horizontal_illuminance / part.horizontal;
  for (auto side : {&SkyIlluminances::horizontal, &SkyIlluminances::north, &SkyIlluminances::east,
                    &SkyIlluminances::south, &SkyIlluminances::west})
    part.*side *= scale;
  return part;
}

double ratio_of(const OutsideLight& light) {
  const auto zenith = light.model.relative_luminance({0.0, 0.0, 1.0});
  return zenith > 0.0 ? relative_illuminances(light.model).horizontal / zenith : 0.0;
}

double ground_of(const OutsideLight& light) {
  return ground_luminance(light.albedo, light.horizontal_illuminance + light.direct_horizontal_illuminance());
}

Json number_or_null(const std::optional<double>& number) { return number ? Json(*number) : Json(nullptr); }

Json hour_json(const ChosenHour& hour) {
  const auto& record = hour.record();
  return {{"file", hour.weather.file},
          {"place", hour.weather.place},
          {"middle", text_of(record.middle, hour.weather.timezone)},
          {"direct_normal_irradiance", number_or_null(record.direct_normal)},
          {"diffuse_horizontal_irradiance", number_or_null(record.diffuse_horizontal)},
          {"dew_point", mean_dew_point(hour.weather, hour.index)}};
}

}  // namespace

std::string text_of(const OutsideLight& light) {
  const auto part = illuminances_of(light);
  auto text = title_of(light) + "\n";
  if (light.hour)
    text += line("hour", fmt::format("{}, {}; middle {}", light.hour->weather.file, light.hour->weather.place,
                                     text_of(light.hour->record().middle, light.hour->weather.timezone)));
  if (light.sun)
    text += line("sun", fmt::format("elevation {:.2f}°, azimuth {:.2f}° from north through east",
                                    light.sun->elevation, light.sun->azimuth));
  if (light.perez)
    text += line("weather", fmt::format("clearness {:.3f}, brightness {:.4f}, bin {} of 8",
                                        light.perez->clearness, light.perez->brightness, light.perez->bin));
  text += line("zenith luminance", fmt::format("{:.6g} cd/m²", light.zenith_luminance()));
  text += line("horizontal", fmt::format("{:.6g} lx by the sky", part.horizontal));
  text += line("horizontal/zenith", fmt::format("{:.5f}", ratio_of(light)));
  text += line("vertical",
               fmt::format("north {:.5g} lx, east {:.5g} lx, south {:.5g} lx, west {:.5g} lx by the sky",
                           part.north, part.east, part.south, part.west));
  if (light.direct_normal_illuminance)
    text += line("by the sun",
                 fmt::format("{:.6g} lx facing it, {:.6g} lx horizontal", *light.direct_normal_illuminance,
                             light.direct_horizontal_illuminance()));
  text += line("ground", fmt::format("{:.5g} cd/m², albedo {:g}", ground_of(light), light.albedo));
  return text;
}

std::string json_of(const OutsideLight& light, const std::string& output) {
  const auto part = illuminances_of(light);
  const auto ratio = ratio_of(light);
  Json json = {
      {"command", "sky"},
      {"kind", light.kind},
      {"zenith_luminance", light.zenith_luminance()},
      {"horizontal_illuminance", part.horizontal},
      {"horizontal_over_zenith", ratio > 0.0 ? Json(ratio) : Json(nullptr)},
      {"vertical_illuminance",
       {{"north", part.north}, {"east", part.east}, {"south", part.south}, {"west", part.west}}},
      {"sun", light.sun ? Json{{"elevation", light.sun->elevation}, {"azimuth", light.sun->azimuth}}
                        : Json(nullptr)},
      {"direct_normal_illuminance", number_or_null(light.direct_normal_illuminance)},
      {"direct_horizontal_illuminance",
       light.direct_normal_illuminance ? Json(light.direct_horizontal_illuminance()) : Json(nullptr)},
      {"albedo", light.albedo},
      {"ground_luminance", ground_of(light)},
      {"perez", light.perez ? Json{{"clearness", light.perez->clearness},
                                   {"brightness", light.perez->brightness},
                                   {"bin", light.perez->bin},
                                   {"parameters", light.perez->parameters}}
                            : Json(nullptr)},
      {"weather", light.hour ? hour_json(*light.hour) : Json(nullptr)},
      {"outputs", output.empty() ? Json::array() : Json::array({output})}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace luxel
