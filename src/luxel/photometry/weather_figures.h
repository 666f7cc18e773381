// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "luxel/photometry/weather.h"

namespace luxel {

// The light of one record.
struct BrightHour {
  std::size_t hour = 0;              // index into Weather::hours
  double global_illuminance = 0.0;   // of the ground by sky and sun, lx
  double diffuse_illuminance = 0.0;  // of the ground by the sky, lx
};

struct WeatherFigures {
  double global = 0.0, direct_normal = 0.0, diffuse = 0.0;  // sums, Wh/m²
  double light_hours = 0.0, sun_hours = 0.0;                // h with global light, with direct light
  bool is_modelled = false;           // illuminances are Perez's by the irradiances, since the file has none
  bool has_global = true;             // of the file; else it is the sum of diffuse and direct
  std::vector<BrightHour> brightest;  // the highest global illuminances, at most 5, the highest first

  // The half of the records with the highest diffuse illuminance: 4,380 hours of a year, which EN 17037 takes
  // for the hours of daylight.
  double bright_half_hours = 0.0;   // h
  double bright_half_min = 0.0;     // the lowest diffuse illuminance among them, lx
  double bright_half_median = 0.0;  // their median, lx
};

WeatherFigures weather_figures(const Weather& weather);

// A row of EN 17037, table A.1: illuminances on half and on 95 % of the reference plane, lx.
struct DaylightTarget {
  const char* level;
  double target, minimum;
};
inline constexpr DaylightTarget daylight_targets[] = {
    {"minimum", 300.0, 100.0}, {"medium", 500.0, 300.0}, {"high", 750.0, 500.0}};

}  // namespace luxel
