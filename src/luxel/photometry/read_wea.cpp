// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/photometry/read_weather.h"
#include "luxel/photometry/table_text.h"

namespace luxel {
namespace {

// weather_data_file_units.
enum class Units { none, direct_normal = 1, direct_horizontal = 2, illuminance = 3 };

constexpr double max_irradiance = 1367.0;  // W/m²: outside the atmosphere

class Reader {
 public:
  Reader(const std::vector<std::string_view>& lines, const std::string& file) : lines_(lines) {
    weather_.file = file;
    weather_.format = "WEA";
  }

  Weather read() {
    for (; line_ < lines_.size(); ++line_) {
      const auto fields = fields_of(lines_[line_], Separator::blank);
      if (fields.empty()) continue;
      if (field_number(fields[0])) break;
      read_header(fields);
    }
    check_header();
    for (; line_ < lines_.size(); ++line_)
      if (const auto fields = fields_of(lines_[line_], Separator::blank); !fields.empty())
        read_record(fields);
    if (weather_.hours.empty())
      throw InputError(weather_.file, lines_.size(), "the file ends before its first hour of weather");
    find_intervals();
    date_hours(weather_);
    if (units_ == Units::direct_horizontal) face_the_sun();
    return std::move(weather_);
  }

 private:
  [[noreturn]] void fail(const std::string& sentence) const {
    throw InputError(weather_.file, line_ + 1, sentence);
  }

  void read_header(const std::vector<std::string_view>& fields) {
    const auto key = fields[0];
    if (key == "place") {
      weather_.place = cleaned(lines_[line_].substr(lines_[line_].find("place") + 5));
      std::replace(weather_.place.begin(), weather_.place.end(), '_', ' ');
      return;
    }
    constexpr std::array<std::string_view, 5> keys = {"latitude", "longitude", "time_zone", "site_elevation",
                                                      "weather_data_file_units"};
    const auto which = std::find(keys.begin(), keys.end(), key) - keys.begin();
    if (which == static_cast<std::ptrdiff_t>(keys.size()))
      fail(fmt::format("expected a line of the header, such as latitude 52.5, or a record, found '{}'",
                       shown(lines_[line_])));
    const auto number = fields.size() > 1 ? field_number(fields[1]) : std::nullopt;
    if (!number) fail(fmt::format("expected a number after {}", key));
    header_[static_cast<std::size_t>(which)] = *number;
    header_lines_[static_cast<std::size_t>(which)] = line_ + 1;
  }

  void check_header() {
    constexpr std::array<const char*, 5> names = {"latitude", "longitude", "time_zone", "site_elevation",
                                                  "weather_data_file_units"};
    for (const std::size_t i : {0, 1, 2, 4})
      if (header_lines_[i] == 0) fail(fmt::format("the header lacks {}", names[i]));
    // The format has west positive, and a time zone as the longitude of its meridian.
    set_place(weather_, header_lines_[0], {header_[0], -header_[1], -header_[2] / 15.0, header_[3]});
    const auto units = header_[4];
    if (units != 1.0 && units != 2.0 && units != 3.0)
      throw InputError(weather_.file, header_lines_[4],
                       fmt::format("expected weather_data_file_units 1, 2 or 3, found {:g}", units));
    units_ = static_cast<Units>(static_cast<int>(units));
  }

  void read_record(const std::vector<std::string_view>& fields) {
    if (fields.size() < 5)
      fail(fmt::format("expected month, day, hour, direct and diffuse, found {} fields", fields.size()));
    WeatherHour hour;
    hour.line = line_ + 1;
    const auto month = field_count(fields[0], 1, 12), day = field_count(fields[1], 1, 31);
    const auto time = field_number(fields[2]);
    if (!month || !day || !is_day(static_cast<unsigned>(*month), static_cast<unsigned>(*day)))
      fail(fmt::format("expected month and day, found '{} {}'", shown(fields[0]), shown(fields[1])));
    if (!time || !(*time >= 0.0 && *time <= 24.0))
      fail(fmt::format("expected the hour, 0 to 24, found '{}'", shown(fields[2])));
    hour.month = static_cast<unsigned>(*month);
    hour.day = static_cast<unsigned>(*day);
    hour.end = *time;  // the middle until find_intervals()
    const auto direct = value_of(fields[3], "direct"), diffuse = value_of(fields[4], "diffuse");
    if (units_ == Units::illuminance) {
      hour.direct_normal_illuminance = direct;
      hour.diffuse_illuminance = diffuse;
    } else {
      hour.direct_normal = direct;
      hour.diffuse_horizontal = diffuse;
    }
    weather_.hours.push_back(hour);
  }

  std::optional<double> value_of(std::string_view field, const char* what) {
    const auto value = field_number(field);
    if (!value) fail(fmt::format("expected the {} light, a number, found '{}'", what, shown(field)));
    const auto missing = units_ == Units::illuminance ? 999900.0 : 9999.0;
    if (*value >= missing || *value <= -9000.0) return std::nullopt;
    return std::max(0.0, *value);
  }

  // The smallest step between records of a day is the interval; stamps are its middle.
  void find_intervals() {
    double step = 1.0;
    bool are_whole = true;
    const WeatherHour* previous = nullptr;
    for (const auto& hour : weather_.hours) {
      if (previous && previous->month == hour.month && previous->day == hour.day) {
        if (!(hour.end > previous->end))
          throw InputError(weather_.file, hour.line,
                           fmt::format("expected an hour after {:g}, found {:g}", previous->end, hour.end));
        step = std::min(step, hour.end - previous->end);
      }
      are_whole = are_whole && hour.end == std::floor(hour.end);
      previous = &hour;
    }
    for (auto& hour : weather_.hours) {
      hour.duration = step;
      hour.end += 0.5 * step;
    }
    if (are_whole)
      weather_.oddities.push_back(fmt::format(
          "{}: all stamps are whole hours; the sun is taken at the stamp, as Radiance does, which is half an "
          "hour late if they are the ends of hours",
          weather_.file));
  }

  // Direct irradiance of the ground becomes that of a plane which faces the sun.
  void face_the_sun() {
    std::size_t limited = 0;
    for (std::size_t i = 0; i < weather_.hours.size(); ++i) {
      auto& direct = weather_.hours[i].direct_normal;
      if (!direct || *direct == 0.0) continue;
      const auto sine = sun_of(weather_, i).direction.z;
      const bool is_possible = sine > 0.0 && *direct <= max_irradiance * sine;
      limited += !is_possible;
      direct = is_possible ? *direct / sine : sine > 0.0 ? max_irradiance : 0.0;
    }
    if (limited > 0)
      weather_.oddities.push_back(
          fmt::format("{}: in {} hours the direct light on the ground is more than a sun of {:g} W/m² at its "
                      "elevation can give; it is limited to that",
                      weather_.file, limited, max_irradiance));
  }

  const std::vector<std::string_view>& lines_;
  std::size_t line_ = 0;  // index
  Weather weather_;
  std::array<double, 5> header_ = {};
  std::array<std::size_t, 5> header_lines_ = {};  // from 1; 0: not found
  Units units_ = Units::none;
};

}  // namespace

Weather read_wea(const std::vector<std::string_view>& lines, const std::string& file) {
  return Reader(lines, file).read();
}

}  // namespace luxel
