// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include <fmt/format.h>

#include "luxel/photometry/read_weather.h"

namespace luxel {
namespace {

// As "1 hour" or "36 hours".
std::string hours_text(std::size_t count) {
  return fmt::format("{} {}", count, count == 1 ? "hour" : "hours");
}

std::string records_text(std::size_t count) {
  return fmt::format("{} {}", count, count == 1 ? "record" : "records");
}

void report(Weather& weather, const std::string& sentence) {
  weather.oddities.push_back(weather.file + ": " + sentence);
}

void report_at(Weather& weather, std::size_t line, const std::string& sentence) {
  weather.oddities.push_back(fmt::format("{}:{}: {}", weather.file, line, sentence));
}

void find_missing_records(Weather& weather) {
  const auto per_hour = std::lround(1.0 / weather.hours.front().duration);
  const auto year = static_cast<std::size_t>(per_hour) * (weather.has_leap_day ? 8784 : 8760);
  if (weather.hours.size() == year) return;
  report(weather, fmt::format("{}, where a year has {}; figures of the year are those of a part of it",
                              records_text(weather.hours.size()), year));
  const auto step = std::chrono::seconds(std::lround(3600.0 * weather.hours.front().duration));
  for (std::size_t i = 1; i < weather.hours.size(); ++i) {
    const auto& hour = weather.hours[i];
    const auto& before = weather.hours[i - 1];
    // A file may begin in the middle of a year.
    const bool begins_year = hour.month == 1 && hour.day == 1 && before.month == 12 && before.day == 31;
    if (hour.middle - before.middle == step || begins_year) continue;
    report_at(weather, hour.line, "this record does not follow the one before it in time");
    return;
  }
}

void find_missing_values(Weather& weather) {
  std::size_t missing = 0, first = 0, dew_points = 0;
  for (const auto& hour : weather.hours) {
    dew_points += hour.dew_point.has_value();
    const bool has_light = (hour.direct_normal && hour.diffuse_horizontal) ||
                           (hour.direct_normal_illuminance && hour.diffuse_illuminance);
    if (has_light) continue;
    if (missing++ == 0) first = hour.line;
  }
  if (missing > 0)
    report_at(weather, first,
              fmt::format("{} without direct or diffuse radiation, from this one on; what is missing counts "
                          "as 0",
                          records_text(missing)));
  if (weather.format == "EPW" && dew_points < weather.hours.size())
    report(weather, fmt::format("{} without a dew point, which sets the luminous efficacies",
                                records_text(weather.hours.size() - dew_points)));
}

void check_timezone(Weather& weather) {
  // China's west is 3 hours from its time zone's meridian.
  constexpr double max_difference = 3.3;
  const auto natural = weather.site.longitude / 15.0;
  auto difference = std::abs(weather.timezone - natural);
  difference = std::min(difference, 24.0 - difference);
  if (difference <= max_difference) return;
  const auto flipped = std::abs(weather.timezone + natural);
  report(weather, fmt::format("the longitude {:g} east and the time zone {:+g} h are {:.1f} hours apart{}",
                              weather.site.longitude, weather.timezone, difference,
                              flipped < max_difference ? "; one of them has the wrong sign" : ""));
}

double light_of(const WeatherHour& hour) {
  const auto diffuse = hour.diffuse_horizontal.value_or(hour.diffuse_illuminance.value_or(0.0) / 110.0);
  return std::max(hour.global_horizontal.value_or(0.0), diffuse);
}

// Direct light of hours in whose middle the sun is down, and light of hours of night.
void find_light_by_night(Weather& weather) {
  constexpr double notable = 5.0;    // W/m²: twilight has less
  constexpr double twilight = -3.0;  // degrees
  std::size_t low = 0, never = 0, by_night = 0, first = 0;
  double lost = 0.0;
  for (std::size_t i = 0; i < weather.hours.size(); ++i) {
    const auto& hour = weather.hours[i];
    const auto direct = hour.direct_normal.value_or(hour.direct_normal_illuminance.value_or(0.0) / 110.0);
    if (!(direct > 0.0) && !(light_of(hour) > notable)) continue;
    if (sun_position(hour.middle, weather.site).elevation >= 0.0) continue;
    if (direct > 0.0) {
      const bool rises = sun_of(weather, i).elevation >= 0.0;
      low += rises;
      never += !rises;
      if (!rises) lost += direct * hour.duration;
    }
    const auto half = std::chrono::seconds(std::lround(1800.0 * hour.duration));
    const auto begin = sun_position(hour.middle - half, weather.site).elevation,
               end = sun_position(hour.middle + half, weather.site).elevation;
    if (light_of(hour) > notable && std::max(begin, end) < twilight && by_night++ == 0) first = hour.line;
  }
  if (low > 0)
    weather.notes.push_back(fmt::format(
        "{}: {} with direct light, in whose middle the sun is below the horizon; the sun is taken "
        "at the middle of the part in which it is up",
        weather.file, hours_text(low)));
  if (never > 0)
    report(weather, fmt::format("{} with direct light, in which the sun is never up; their direct light, "
                                "{:.0f} Wh/m² in all, is left out",
                                hours_text(never), lost));
  if (by_night > 0)
    report_at(weather, first,
              fmt::format("{} of light while the sun is more than 3 degrees below the horizon, from this one "
                          "on; time zone, longitude or stamps may be wrong",
                          hours_text(by_night)));
}

// Global irradiance is diffuse plus direct times the sine of the elevation. The shift of the sun for which
// that fits best shows what the stamps mean.
void check_stamps(Weather& weather) {
  constexpr std::array<int, 5> shifts = {0, -60, -30, 30, 60};  // minutes
  constexpr double min_elevation = 8.0;                         // degrees: half hours matter, horizons do not
  constexpr double min_ratio = 2.0;
  std::array<double, shifts.size()> differences = {};
  double direct_sum = 0.0;
  for (const auto& hour : weather.hours) {
    if (!hour.global_horizontal || !hour.diffuse_horizontal || !(hour.direct_normal.value_or(0.0) > 100.0))
      continue;
    if (sun_position(hour.middle, weather.site).elevation < min_elevation) continue;
    direct_sum += *hour.direct_normal;
    for (std::size_t s = 0; s < shifts.size(); ++s) {
      const auto sun = sun_position(hour.middle + std::chrono::minutes(shifts[s]), weather.site);
      differences[s] += std::abs(*hour.global_horizontal - *hour.diffuse_horizontal -
                                 *hour.direct_normal * std::max(0.0, sun.direction.z));
    }
  }
  const auto best = static_cast<std::size_t>(std::min_element(differences.begin(), differences.end()) -
                                             differences.begin());
  if (best == 0 || !(direct_sum > 0.0) || differences[0] < min_ratio * differences[best]) return;
  report(weather, fmt::format("global, direct and diffuse radiation fit each other best with the sun of {} "
                              "minutes {}; the stamps or the time zone may be of another convention",
                              std::abs(shifts[best]), shifts[best] < 0 ? "before" : "later"));
}

}  // namespace

void find_oddities(Weather& weather) {
  find_missing_records(weather);
  find_missing_values(weather);
  check_timezone(weather);
  find_light_by_night(weather);
  check_stamps(weather);
}

}  // namespace luxel
