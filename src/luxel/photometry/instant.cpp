// SPDX-License-Identifier: Apache-2.0
#include "luxel/photometry/instant.h"

#include <charconv>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "luxel/core/error.h"

namespace luxel {
namespace {

constexpr double min_timezone = -12.0, max_timezone = 14.0;  // hours; the world's extremes
constexpr int seconds_per_day = 86400;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Reads a text from left to right; each step returns whether it found the expected part.
struct Reader {
  std::string_view rest;

  bool take(char c) {
    if (!rest.starts_with(c)) return false;
    rest.remove_prefix(1);
    return true;
  }
  bool digits(std::size_t count, int& value) {
    if (rest.size() < count) return false;
    value = 0;
    for (std::size_t i = 0; i < count; ++i) {
      if (!is_digit(rest[i])) return false;
      value = 10 * value + (rest[i] - '0');
    }
    rest.remove_prefix(count);
    return true;
  }
};

// "Z", "+01:00", "-0530" or "+05".
std::optional<double> read_zone(Reader& reader) {
  if (reader.take('Z') || reader.take('z')) return 0.0;
  const bool is_west = reader.take('-');
  int hours = 0, minutes = 0;
  if ((!is_west && !reader.take('+')) || !reader.digits(2, hours)) return std::nullopt;
  if (reader.take(':') ? !reader.digits(2, minutes) : !reader.rest.empty() && !reader.digits(2, minutes))
    return std::nullopt;
  const auto zone = (is_west ? -1.0 : 1.0) * (hours + minutes / 60.0);
  if (minutes > 59 || zone < min_timezone || zone > max_timezone) return std::nullopt;
  return zone;
}

std::optional<CivilTime> read_time(Reader reader) {
  CivilTime time;
  int year = 0, month = 0, day = 0, hour = 0, minute = 0, second = 0;
  if (!reader.digits(4, year) || !reader.take('-') || !reader.digits(2, month) || !reader.take('-') ||
      !reader.digits(2, day))
    return std::nullopt;
  if (!reader.take('T') && !reader.take('t') && !reader.take(' ')) return std::nullopt;
  if (!reader.digits(2, hour) || !reader.take(':') || !reader.digits(2, minute)) return std::nullopt;
  if (reader.take(':') && !reader.digits(2, second)) return std::nullopt;
  if (!reader.rest.empty()) {
    time.timezone = read_zone(reader);
    if (!time.timezone || !reader.rest.empty()) return std::nullopt;
  }
  const std::chrono::year_month_day date{std::chrono::year(year),
                                         std::chrono::month(static_cast<unsigned>(month)),
                                         std::chrono::day(static_cast<unsigned>(day))};
  time.seconds = 3600 * hour + 60 * minute + second;
  if (!date.ok() || year < 1600 || year > 2399 || minute > 59 || second > 59 ||
      time.seconds > seconds_per_day)
    return std::nullopt;
  time.day = date;
  return time;
}

std::chrono::seconds as_seconds(double hours) { return std::chrono::seconds(std::lround(3600.0 * hours)); }

}  // namespace

CivilTime parse_civil_time(const std::string& text) {
  if (const auto time = read_time({text})) return *time;
  throw InputError(
      fmt::format("'{}' is no date and time; expected one such as 2026-03-21T12:00+01:00", text));
}

double parse_timezone(const std::string& text) {
  Reader reader{text};
  if (const auto zone = read_zone(reader); zone && reader.rest.empty()) return *zone;
  std::string_view number = text;
  if (number.starts_with('+') && !number.starts_with("+-")) number.remove_prefix(1);
  double hours = 0.0;
  const auto* end = number.data() + number.size();
  const auto [stop, error] = std::from_chars(number.data(), end, hours);
  if (error != std::errc() || stop != end || !(hours >= min_timezone && hours <= max_timezone))
    throw InputError(fmt::format(
        "'{}' is no time zone; expected hours east of UTC from {:g} to {:g}, such as 5.5 or +05:30", text,
        min_timezone, max_timezone));
  return hours;
}

Instant instant_of(const CivilTime& time, std::optional<double> timezone) {
  const auto zone = time.timezone ? time.timezone : timezone;
  if (!zone)
    throw InputError(
        "the time has no time zone; expected one at its end, such as +01:00 or Z, or a time zone beside it");
  return Instant(time.day) + std::chrono::seconds(time.seconds) - as_seconds(*zone);
}

std::string text_of(Instant instant, double timezone) {
  const auto local = instant + as_seconds(timezone);
  const auto day = std::chrono::floor<std::chrono::days>(local);
  const std::chrono::year_month_day date(day);
  const auto seconds = static_cast<int>((local - day).count());
  const auto zone = static_cast<int>(std::lround(60.0 * std::abs(timezone)));
  auto text = fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}", static_cast<int>(date.year()),
                          static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                          seconds / 3600, seconds / 60 % 60);
  if (seconds % 60 != 0) text += fmt::format(":{:02}", seconds % 60);
  return text + fmt::format("{}{:02}:{:02}", timezone < 0.0 ? '-' : '+', zone / 60, zone % 60);
}

}  // namespace luxel
