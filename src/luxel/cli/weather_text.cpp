// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/weather_text.h"

#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace luxel {
namespace {

using Json = nlohmann::ordered_json;

std::string line(const char* label, const std::string& text) {
  return fmt::format("  {:<18} {}\n", label, text);
}

std::string place_text(const Weather& weather) {
  const auto& site = weather.site;
  const auto zone = std::lround(60.0 * std::abs(weather.timezone));
  return fmt::format("{:.4g}° {}, {:.5g}° {}, {:g} m, UTC{}{:02}:{:02}", std::abs(site.latitude),
                     site.latitude < 0.0 ? "south" : "north", std::abs(site.longitude),
                     site.longitude < 0.0 ? "west" : "east", weather.elevation,
                     weather.timezone < 0.0 ? '-' : '+', zone / 60, zone % 60);
}

std::string length_text(const Weather& weather) {
  const auto minutes = std::lround(60.0 * weather.hours.front().duration);
  return fmt::format("{} of {}{}", weather.hours.size(),
                     minutes == 60 ? std::string("1 h") : fmt::format("{} min", minutes),
                     weather.has_leap_day ? ", with 29 February" : "");
}

std::string hour_text(const WeatherHour& hour) {
  return fmt::format("{:02}-{:02}T{:02}:{:02}", hour.month, hour.day, static_cast<int>(hour.end),
                     std::lround(60.0 * hour.end) % 60);
}

// Percent of the median.
double factor(double illuminance, const WeatherFigures& figures) {
  return 100.0 * illuminance / figures.bright_half_median;
}

std::vector<std::string> oddities_of(const Weather& weather) {
  auto sentences = weather.oddities;
  sentences.insert(sentences.end(), weather.notes.begin(), weather.notes.end());
  return sentences;
}

}  // namespace

std::string text_of(const Weather& weather, const WeatherFigures& figures) {
  auto text = fmt::format("{}: {}, {}\n", weather.file, weather.format,
                          weather.place.empty() ? "a place without a name" : weather.place);
  text += line("place", place_text(weather));
  text += line("records", length_text(weather));
  text += line("light", fmt::format("{:g} h, direct sun {:g} h", figures.light_hours, figures.sun_hours));
  text += line("sums",
               fmt::format("global {:.1f}, direct normal {:.1f}, diffuse {:.1f} kWh/m²{}",
                           figures.global / 1000.0, figures.direct_normal / 1000.0, figures.diffuse / 1000.0,
                           figures.has_global ? "" : "; global is the sum of the other two"));
  for (std::size_t i = 0; i < figures.brightest.size(); ++i) {
    const auto& hour = figures.brightest[i];
    text +=
        line(i == 0 ? "brightest hours" : "",
             fmt::format("{} {:.0f} lx, {:.0f} lx of them by the sky", hour_text(weather.hours[hour.hour]),
                         hour.global_illuminance, hour.diffuse_illuminance));
  }
  text += line("daylight hours",
               fmt::format("{:g} h of the highest diffuse illuminance: {:.0f} lx or more, "
                           "median {:.0f} lx{}",
                           figures.bright_half_hours, figures.bright_half_min, figures.bright_half_median,
                           figures.is_modelled ? ", by Perez's efficacies" : ""));
  if (figures.bright_half_median > 0.0)
    for (const auto& row : daylight_targets)
      text += line(
          &row == daylight_targets ? "daylight factors" : "",
          fmt::format("{:<8} {:.2f} % for {:g} lx, {:.2f} % for {:g} lx", row.level,
                      factor(row.target, figures), row.target, factor(row.minimum, figures), row.minimum));
  const auto oddities = oddities_of(weather);
  for (std::size_t i = 0; i < oddities.size(); ++i) text += line(i == 0 ? "oddities" : "", oddities[i]);
  return text;
}

std::string json_of(const Weather& weather, const WeatherFigures& figures) {
  Json brightest = Json::array(), targets = Json::array();
  for (const auto& hour : figures.brightest)
    brightest.push_back({{"hour", hour_text(weather.hours[hour.hour])},
                         {"global_illuminance", hour.global_illuminance},
                         {"diffuse_illuminance", hour.diffuse_illuminance}});
  for (const auto& row : daylight_targets) {
    const auto percent = [&](double illuminance) {
      return figures.bright_half_median > 0.0 ? Json(factor(illuminance, figures)) : Json(nullptr);
    };
    targets.push_back({{"level", row.level},
                       {"target_illuminance", row.target},
                       {"target_factor_percent", percent(row.target)},
                       {"minimum_illuminance", row.minimum},
                       {"minimum_factor_percent", percent(row.minimum)}});
  }
  Json json = {{"command", "weather"},
               {"file", weather.file},
               {"format", weather.format},
               {"place", weather.place},
               {"latitude", weather.site.latitude},
               {"longitude", weather.site.longitude},
               {"timezone", weather.timezone},
               {"elevation", weather.elevation},
               {"records", weather.hours.size()},
               {"record_hours", weather.hours.front().duration},
               {"has_leap_day", weather.has_leap_day},
               {"light_hours", figures.light_hours},
               {"sun_hours", figures.sun_hours},
               {"global_horizontal", figures.global},
               {"direct_normal", figures.direct_normal},
               {"diffuse_horizontal", figures.diffuse},
               {"illuminances", figures.is_modelled ? "model" : "file"},
               {"brightest_hours", std::move(brightest)},
               {"daylight_hours",
                {{"count", figures.bright_half_hours},
                 {"min_diffuse_illuminance", figures.bright_half_min},
                 {"median_diffuse_illuminance", figures.bright_half_median}}},
               {"daylight_factors", std::move(targets)},
               {"oddities", oddities_of(weather)}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace luxel
