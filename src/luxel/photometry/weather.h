// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "luxel/photometry/instant.h"
#include "luxel/photometry/perez_sky.h"
#include "luxel/photometry/sun_position.h"

namespace luxel {

// One record of a weather file: means over an interval, an hour or a part of one. Values that the file lacks
// are nothing.
struct WeatherHour {
  unsigned month = 1, day = 1;
  double end = 1.0;       // of the interval: hours of local standard time since midnight, (0, 24.5]
  double duration = 1.0;  // h
  Instant middle = {};    // of the interval, in 2023, or in 2024 where the file has a 29 February
  std::size_t line = 0;   // in the file, from 1

  // Irradiances, W/m²: of the ground by sky and sun; of a plane that faces the sun by the sun; of the ground
  // by the sky.
  std::optional<double> global_horizontal, direct_normal, diffuse_horizontal;
  // The same as illuminances, lx.
  std::optional<double> global_illuminance, direct_normal_illuminance, diffuse_illuminance;
  std::optional<double> dew_point;  // °C
};

// A year of weather, or a part of one.
struct Weather {
  std::string file, format;  // "EPW" or "WEA"
  std::string place;         // city, region, country
  Site site;
  double timezone = 0.0;   // hours east of UTC, without daylight saving time
  double elevation = 0.0;  // m above the sea
  bool has_leap_day = false;
  std::vector<WeatherHour> hours;     // in the order of the file
  std::vector<std::string> oddities;  // what may be wrong with the file: sentences, with the line where known
  std::vector<std::string> notes;     // how the usual traps of such files were handled: sentences
};

// Reads a file of EnergyPlus (.epw) or of Radiance and Daysim (.wea), recognised by its first line. Rows are
// means over the hour that ends at their stamp (EPW), or over an interval around it (WEA). Years are ignored:
// the months of a typical year come from different ones. Throws InputError with file and line.
Weather load_weather(const std::string& file);
// Reads the weather from a file in memory, which errors call `file`.
Weather read_weather(std::string_view bytes, const std::string& file);

// The sun of an hour: at the middle of its interval. Where it is below the horizon then, but the hour has
// direct light, at the middle of the part of the interval with the sun above the horizon; below the horizon
// where it does not rise at all: then the direct light is that of no sun.
SunPosition sun_of(const Weather& weather, std::size_t hour);

// Mean dew point of an hour and the two before it, °C, as Perez's precipitable water has it; 11 where the
// file has none.
double mean_dew_point(const Weather& weather, std::size_t hour);

// Sky and sun of an hour by Perez's model; missing irradiances count as 0. Where a file has illuminances
// only, irradiances are found by the model's own efficacies, and the illuminances are those of the file.
PerezSky perez_sky(const Weather& weather, std::size_t hour, const SunPosition& sun);

// The index of the record whose interval holds a time of a day, or nothing. hour: of local standard time, (0,
// 24]; an interval includes its end, so that whole hours are the stamps of EPW.
std::optional<std::size_t> find_hour(const Weather& weather, unsigned month, unsigned day, double hour);

}  // namespace luxel
