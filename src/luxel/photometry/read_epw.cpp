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

// Columns of a record, from 0. EnergyPlus, "Auxiliary Programs", EPW data dictionary.
constexpr std::size_t month_column = 1, day_column = 2, hour_column = 3, dew_point_column = 7,
                      min_columns = 16;

struct Quantity {
  const char* name;
  std::size_t column;
  std::optional<double> WeatherHour::*value;
  double missing;  // this value and larger ones stand for none
};
constexpr std::array<Quantity, 6> quantities = {
    {{"the global horizontal radiation", 13, &WeatherHour::global_horizontal, 9999.0},
     {"the direct normal radiation", 14, &WeatherHour::direct_normal, 9999.0},
     {"the diffuse horizontal radiation", 15, &WeatherHour::diffuse_horizontal, 9999.0},
     {"the global horizontal illuminance", 16, &WeatherHour::global_illuminance, 999900.0},
     {"the direct normal illuminance", 17, &WeatherHour::direct_normal_illuminance, 999900.0},
     {"the diffuse horizontal illuminance", 18, &WeatherHour::diffuse_illuminance, 999900.0}}};
constexpr std::size_t radiations = 3;
constexpr double missing_dew_point = 99.9;  // °C

// Above the sun's irradiance outside the atmosphere, W/m².
constexpr double impossible_irradiance = 1600.0;

class Reader {
 public:
  Reader(const std::vector<std::string_view>& lines, const std::string& file) : lines_(lines) {
    weather_.file = file;
    weather_.format = "EPW";
  }

  Weather read() {
    read_location();
    for (; line_ < lines_.size() && !is_record(lines_[line_]); ++line_) read_header(lines_[line_]);
    for (; line_ < lines_.size(); ++line_)
      if (!cleaned(lines_[line_]).empty()) read_record(lines_[line_]);
    if (weather_.hours.empty())
      throw InputError(weather_.file, lines_.size(), "the file ends before its first hour of weather");
    report_negative();
    scale_to_watts();
    drop_constant_illuminances();
    return std::move(weather_);
  }

 private:
  [[noreturn]] void fail(const std::string& sentence) const {
    throw InputError(weather_.file, line_ + 1, sentence);
  }

  static bool is_record(std::string_view line) {
    const auto text = cleaned(line.substr(0, 40));
    return !text.empty() && (text[0] == '-' || (text[0] >= '0' && text[0] <= '9'));
  }

  void read_location() {
    const auto fields = fields_of(lines_[0], Separator::comma);
    if (fields.size() < 10)
      fail(
          fmt::format("expected LOCATION with 9 fields, the last four of them latitude, longitude, time zone "
                      "and elevation, found {} fields",
                      fields.size() - 1));
    std::array<double, 4> numbers;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      constexpr std::array<const char*, 4> names = {"latitude", "longitude", "time zone", "elevation"};
      const auto number = field_number(fields[6 + i]);
      if (!number) fail(fmt::format("expected the {}, a number, found '{}'", names[i], shown(fields[6 + i])));
      numbers[i] = *number;
    }
    for (std::size_t i = 1; i <= 3; ++i)
      if (const auto part = cleaned(fields[i]); !part.empty() && part != "-")
        weather_.place += (weather_.place.empty() ? "" : ", ") + part;
    set_place(weather_, 1, {numbers[0], numbers[1], numbers[2], numbers[3]});
    line_ = 1;
  }

  void read_header(std::string_view line) {
    const auto fields = fields_of(line, Separator::comma);
    if (fields[0] != "DATA PERIODS" || fields.size() < 3) return;
    const auto count = field_count(fields[2], 1, 60);
    if (!count || 60 % *count != 0)
      fail(fmt::format("expected the number of records per hour, a divisor of 60, found '{}'",
                       shown(fields[2])));
    per_hour_ = static_cast<std::size_t>(*count);
    if (const auto periods = field_count(fields[1], 1, 1000); periods && *periods > 1)
      weather_.oddities.push_back(fmt::format("{}:{}: the file has {} data periods; they are read as one",
                                              weather_.file, line_ + 1, *periods));
  }

  unsigned read_count(std::string_view field, const char* what, int high) const {
    const auto count = field_count(field, 1, high);
    if (!count) fail(fmt::format("expected the {}, 1 to {}, found '{}'", what, high, shown(field)));
    return static_cast<unsigned>(*count);
  }

  void read_record(std::string_view line) {
    const auto fields = fields_of(line, Separator::comma);
    if (fields.size() < min_columns)
      fail(
          fmt::format("expected a record of at least {} fields, up to the diffuse horizontal radiation, "
                      "found {}",
                      min_columns, fields.size()));
    WeatherHour hour;
    hour.line = line_ + 1;
    hour.month = read_count(fields[month_column], "month", 12);
    hour.day = read_count(fields[day_column], "day", 31);
    if (!is_day(hour.month, hour.day)) fail(fmt::format("month {} has no day {}", hour.month, hour.day));
    place_in_hour(hour, read_count(fields[hour_column], "hour", 24));
    for (const auto& quantity : quantities)
      if (quantity.column < fields.size()) hour.*quantity.value = value_of(fields[quantity.column], quantity);
    const auto dew_point = field_number(fields[dew_point_column]);
    if (dew_point && *dew_point > -90.0 && *dew_point < missing_dew_point) hour.dew_point = dew_point;
    weather_.hours.push_back(hour);
  }

  // Minutes are ignored: files of one record per hour have 0, 30 or 60, and those of several disagree about
  // the first. Records of an hour follow each other.
  void place_in_hour(WeatherHour& hour, unsigned stamp) {
    auto& count = records_[((hour.month - 1) * 31 + hour.day - 1) * 24 + stamp - 1];
    if (count >= per_hour_)
      fail(
          fmt::format("hour {} of day {} of month {} has more than {} {}; a file may hold one year, and DATA "
                      "PERIODS must have its number of records per hour",
                      stamp, hour.day, hour.month, per_hour_, per_hour_ == 1 ? "record" : "records"));
    ++count;
    hour.duration = 1.0 / static_cast<double>(per_hour_);
    hour.end = static_cast<double>(stamp - 1) + static_cast<double>(count) * hour.duration;
  }

  std::optional<double> value_of(std::string_view field, const Quantity& quantity) {
    if (field.empty()) return std::nullopt;
    const auto value = field_number(field);
    if (!value) fail(fmt::format("expected {}, a number, found '{}'", quantity.name, shown(field)));
    if (*value >= quantity.missing || *value <= -9000.0) return std::nullopt;
    if (*value >= 0.0) return value;
    if (negative_++ == 0) first_negative_ = line_ + 1;
    return 0.0;
  }

  void report_negative() {
    if (negative_ > 0)
      weather_.oddities.push_back(
          fmt::format("{}:{}: {} below 0 {} as 0", weather_.file, first_negative_,
                      negative_ == 1 ? "a value" : fmt::format("{} values", negative_),
                      negative_ == 1 ? "counts" : "count"));
  }

  // Wh/m² per record become mean W/m². Several records per hour that hold W/m² already are recognised by
  // values that could not be.
  void scale_to_watts() {
    if (per_hour_ == 1) return;
    const auto scale = static_cast<double>(per_hour_);
    double largest = 0.0;
    for (const auto& hour : weather_.hours)
      for (std::size_t q = 0; q < radiations; ++q)
        largest = std::max(largest, (hour.*quantities[q].value).value_or(0.0));
    const bool has_watts = largest * scale > impossible_irradiance;
    weather_.notes.push_back(
        fmt::format("{}: {} records per hour; their radiation counts as {}", weather_.file, per_hour_,
                    has_watts ? "mean W/m², since as Wh/m² it would be more than the sun gives"
                              : "Wh/m² per record, as the format has it"));
    if (has_watts) return;
    for (auto& hour : weather_.hours)
      for (std::size_t q = 0; q < radiations; ++q)
        if (auto& value = hour.*quantities[q].value) *value *= scale;
  }

  // Programs without illuminances write one value everywhere.
  void drop_constant_illuminances() {
    double low = 1e30, high = -1.0;
    for (const auto& hour : weather_.hours)
      if (hour.diffuse_illuminance && hour.diffuse_horizontal.value_or(0.0) > 0.0) {
        low = std::min(low, *hour.diffuse_illuminance);
        high = std::max(high, *hour.diffuse_illuminance);
      }
    if (low < high || high < 0.0) return;
    std::size_t days = 0;
    for (const auto& hour : weather_.hours) days += hour.diffuse_horizontal.value_or(0.0) > 0.0;
    if (days < 2) return;
    for (auto& hour : weather_.hours)
      hour.global_illuminance = hour.direct_normal_illuminance = hour.diffuse_illuminance = std::nullopt;
    weather_.oddities.push_back(
        fmt::format("{}: all diffuse illuminances are {:g}; illuminances are ignored", weather_.file, high));
  }

  const std::vector<std::string_view>& lines_;
  std::size_t line_ = 0;  // index
  Weather weather_;
  std::size_t per_hour_ = 1;
  std::array<std::size_t, 12 * 31 * 24> records_ = {};  // of each hour of the year
  std::size_t negative_ = 0, first_negative_ = 0;
};

}  // namespace

Weather read_epw(const std::vector<std::string_view>& lines, const std::string& file) {
  return Reader(lines, file).read();
}

}  // namespace luxel
