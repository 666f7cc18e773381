// SPDX-License-Identifier: Apache-2.0
#include "scenes/weather/temperate_year.h"

#include <chrono>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "luxel/photometry/sun_position.h"

namespace luxel::scenes {
namespace {

enum class Day { clear, broken, overcast };

Day kind_of(int day) {
  const auto u = std::fmod(0.618034 * day, 1.0);
  const auto clear = 0.27 - 0.13 * std::cos(2.0 * std::numbers::pi * (day + 10) / 365.0);
  return u < clear ? Day::clear : u < clear + 0.33 ? Day::broken : Day::overcast;
}

struct Irradiances {
  double direct_normal = 0.0, diffuse = 0.0;  // W/m²
};

Irradiances irradiances_of(Day day, double elevation) {
  if (!(elevation > 0.0)) return {};
  const auto sine = std::sin(elevation * std::numbers::pi / 180.0);
  const auto mass = 1.0 / (sine + 0.50572 * std::pow(elevation + 6.07995, -1.6364));
  const Irradiances clear{1353.0 * std::pow(0.7, std::pow(mass, 0.678)), 110.0 * std::pow(sine, 0.4)};
  const auto overcast = 300.0 * sine;
  switch (day) {
    case Day::clear:
      return clear;
    case Day::broken:
      return {0.5 * clear.direct_normal, 0.5 * (clear.diffuse + overcast) + 60.0 * sine};
    case Day::overcast:
      break;
  }
  return {0.0, overcast};
}

}  // namespace

std::string temperate_year() {
  constexpr Site site{50.0, 10.0};
  std::string text =
      "place temperate_year_made_by_Luxel\nlatitude 50\nlongitude -10\ntime_zone -15\nsite_elevation 200\n"
      "weather_data_file_units 1\n";
  const std::chrono::sys_days begin = std::chrono::year(2023) / std::chrono::January / 1;
  for (int day = 1; day <= 365; ++day) {
    const auto date = begin + std::chrono::days(day - 1);
    const std::chrono::year_month_day parts(date);
    for (int hour = 0; hour < 24; ++hour) {
      const auto middle = Instant(date) + std::chrono::minutes(60 * hour + 30 - 60);
      const auto light = irradiances_of(kind_of(day), sun_position(middle, site).elevation);
      text += fmt::format("{} {} {}.5 {:.0f} {:.0f}\n", static_cast<unsigned>(parts.month()),
                          static_cast<unsigned>(parts.day()), hour, light.direct_normal, light.diffuse);
    }
  }
  return text;
}

}  // namespace luxel::scenes
