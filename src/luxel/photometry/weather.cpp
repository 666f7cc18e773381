// SPDX-License-Identifier: Apache-2.0
#include "luxel/photometry/weather.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/core/output_file.h"
#include "luxel/core/text_lines.h"
#include "luxel/photometry/read_weather.h"
#include "luxel/photometry/table_text.h"

namespace luxel {
namespace {

constexpr int common_year = 2023, leap_year = 2024;
constexpr double default_dew_point = 11.0;  // °C, as gendaymtx

// Irradiances that the model's efficacies turn into these illuminances.
PerezInput input_of_illuminances(double direct, double diffuse, PerezInput input, const Vec3d& sun) {
  constexpr double efficacy = 110.0;  // lm/W, to begin with
  constexpr int rounds = 10;          // bins have jumps, between which there may be no solution
  input.direct_normal = direct / efficacy;
  input.diffuse_horizontal = diffuse / efficacy;
  for (int i = 0; i < rounds; ++i) {
    const auto sky = perez_sky(input, sun);
    if (sky.diffuse_illuminance > 0.0) input.diffuse_horizontal *= diffuse / sky.diffuse_illuminance;
    if (sky.direct_normal_illuminance > 0.0) input.direct_normal *= direct / sky.direct_normal_illuminance;
  }
  return input;
}

}  // namespace

bool is_day(unsigned month, unsigned day) {
  return std::chrono::year_month_day(std::chrono::year(leap_year), std::chrono::month(month),
                                     std::chrono::day(day))
      .ok();
}

void date_hours(Weather& weather) {
  weather.has_leap_day = std::any_of(weather.hours.begin(), weather.hours.end(), [](const WeatherHour& hour) {
    return hour.month == 2 && hour.day == 29;
  });
  const std::chrono::year year(weather.has_leap_day ? leap_year : common_year);
  for (auto& hour : weather.hours) {
    const std::chrono::sys_days day =
        std::chrono::year_month_day(year, std::chrono::month(hour.month), std::chrono::day(hour.day));
    const auto middle = hour.end - 0.5 * hour.duration - weather.timezone;
    hour.middle = Instant(day) + std::chrono::seconds(std::lround(3600.0 * middle));
  }
}

void set_place(Weather& weather, std::size_t line, const Header& header) {
  const auto check = [&](const char* name, double value, double low, double high) {
    if (!(value >= low && value <= high))
      throw InputError(weather.file, line,
                       fmt::format("expected a {} from {:g} to {:g}, found {:g}", name, low, high, value));
  };
  check("latitude", header.latitude, -90.0, 90.0);
  check("longitude", header.longitude, -180.0, 180.0);
  check("time zone in hours", header.timezone, -12.0, 14.0);
  check("elevation in metres", header.elevation, -1000.0, 9999.9);
  weather.site = {header.latitude, header.longitude};
  weather.timezone = header.timezone;
  weather.elevation = header.elevation;
}

Weather read_weather(std::string_view bytes, const std::string& file) {
  const auto lines = text_lines(bytes);
  const auto first = lines.empty() ? std::string_view() : lines[0];
  if (first.starts_with("LOCATION")) {
    auto weather = read_epw(lines, file);
    date_hours(weather);
    find_oddities(weather);
    return weather;
  }
  if (first.starts_with("place")) {
    auto weather = read_wea(lines, file);
    find_oddities(weather);
    return weather;
  }
  throw InputError(file, 1,
                   fmt::format("expected a weather file, which begins with LOCATION (EPW) or place (WEA), "
                               "found '{}'",
                               shown(first)));
}

Weather load_weather(const std::string& file) {
  return read_weather(read_file(file, max_weather_bytes), file);
}

SunPosition sun_of(const Weather& weather, std::size_t index) {
  const auto& hour = weather.hours[index];
  const auto sun = sun_position(hour.middle, weather.site);
  const bool has_direct =
      hour.direct_normal.value_or(0.0) > 0.0 || hour.direct_normal_illuminance.value_or(0.0) > 0.0;
  if (sun.elevation >= 0.0 || !has_direct) return sun;
  const auto half = std::lround(30.0 * hour.duration);  // minutes
  std::int64_t minutes = 0, sum = 0;
  for (auto minute = -half; minute <= half; ++minute)
    if (sun_position(hour.middle + std::chrono::minutes(minute), weather.site).elevation >= 0.0) {
      ++minutes;
      sum += minute;
    }
  if (minutes == 0) return sun;
  return sun_position(hour.middle + std::chrono::seconds(60 * sum / minutes), weather.site);
}

double mean_dew_point(const Weather& weather, std::size_t index) {
  constexpr double hours = 3.0;
  double sum = 0.0;
  int count = 0;
  double spanned = 0.0;
  for (auto i = index + 1; i-- > 0 && spanned < hours - 1e-9;) {
    spanned += weather.hours[i].duration;
    if (const auto dew_point = weather.hours[i].dew_point) {
      sum += *dew_point;
      ++count;
    }
  }
  return count > 0 ? sum / count : default_dew_point;
}

PerezSky perez_sky(const Weather& weather, std::size_t index, const SunPosition& sun) {
  const auto& hour = weather.hours[index];
  PerezInput input{hour.direct_normal.value_or(0.0), hour.diffuse_horizontal.value_or(0.0),
                   mean_dew_point(weather, index), sun.orbit_factor()};
  const bool has_illuminances = !hour.direct_normal && !hour.diffuse_horizontal;
  const auto direct = hour.direct_normal_illuminance.value_or(0.0),
             diffuse = hour.diffuse_illuminance.value_or(0.0);
  if (has_illuminances) input = input_of_illuminances(direct, diffuse, input, sun.direction);
  auto sky = perez_sky(input, sun.direction);
  if (has_illuminances) {
    sky.diffuse_illuminance = diffuse;
    sky.direct_normal_illuminance = direct;
  }
  if (sun.elevation < 0.0) sky.direct_normal_illuminance = 0.0;
  return sky;
}

std::optional<std::size_t> find_hour(const Weather& weather, unsigned month, unsigned day, double time) {
  constexpr double rounding = 1e-6;  // h: a third of an hour is no binary number
  for (std::size_t i = 0; i < weather.hours.size(); ++i) {
    const auto& hour = weather.hours[i];
    if (hour.month == month && hour.day == day && time > hour.end - hour.duration + rounding &&
        time <= hour.end + rounding)
      return i;
  }
  return std::nullopt;
}

}  // namespace luxel
