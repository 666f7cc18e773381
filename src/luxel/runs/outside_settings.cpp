// SPDX-License-Identifier: Apache-2.0
#include "luxel/runs/outside_settings.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace luxel {
namespace {

constexpr double max_illuminance = 1e6;  // lx: ten times what the sun gives

// "52.5,13.4", within limits.
std::pair<double, double> parse_two(const std::string& option, const std::string& text, const char* example,
                                    const Vec3d& limits) {
  const auto comma = text.find(',');
  const auto first = parse_double(text.substr(0, comma));
  const auto second = parse_double(comma == std::string::npos ? std::string() : text.substr(comma + 1));
  if (!first || !second || !(std::abs(*first) <= limits.x) || !(*second >= limits.y && *second <= limits.z))
    throw UsageError(
        fmt::format("--{}: expected two numbers in degrees such as {}, not '{}'", option, example, text));
  return {*first, *second};
}

template <typename Parse>
auto usage_of(const char* option, const Parse& parse) {
  try {
    return parse();
  } catch (const InputError& error) {
    throw UsageError(fmt::format("--{}: {}", option, error.what()));
  }
}

int cie_type_of(const std::string& kind) {
  const std::string_view prefix = "cie:";
  if (!kind.starts_with(prefix)) return 0;
  int type = 0;
  const auto* end = kind.data() + kind.size();
  const auto [stop, error] = std::from_chars(kind.data() + prefix.size(), end, type);
  return error == std::errc() && stop == end && type >= 1 && type <= sky_types ? type : 0;
}

// An option whose default is not a number.
struct NumberOrAuto {
  const char* name;
  const char* unit;
  const char* help;
  std::optional<double>& value;
  double min, max;
};

void add_number_or_auto(OptionSet& set, const NumberOrAuto& option) {
  auto& value = option.value;
  const auto parse = [&value, name = option.name, min = option.min,
                      max = option.max](const std::string& text) {
    value.reset();
    if (text == "auto") return;
    value = parse_double(text);
    if (!value || !(*value >= min && *value <= max))
      throw UsageError(
          fmt::format("--{}: expected auto or a number from {:g} to {:g}, not '{}'", name, min, max, text));
  };
  set.add({option.name, option.unit, option.help, parse,
           [&value] { return value ? fmt::format("{}", *value) : std::string("auto"); }});
}

}  // namespace

HourOfYear parse_hour_of_year(const std::string& text) {
  HourOfYear hour;
  std::string_view rest = text;
  const auto number = [&rest](std::size_t digits, unsigned& value) {
    if (rest.size() < digits) return false;
    const auto [stop, error] = std::from_chars(rest.data(), rest.data() + digits, value);
    if (error != std::errc() || stop != rest.data() + digits) return false;
    rest.remove_prefix(digits);
    return true;
  };
  const auto sign = [&rest](char c) {
    if (!rest.starts_with(c)) return false;
    rest.remove_prefix(1);
    return true;
  };
  unsigned year = 0, whole = 0, minute = 0;
  if (rest.size() > 4 && rest[4] == '-' && !(number(4, year) && sign('-'))) rest = {};
  const bool is_read = number(2, hour.month) && sign('-') && number(2, hour.day) && sign('T') &&
                       number(2, whole) && (!sign(':') || number(2, minute)) && rest.empty();
  hour.hour = whole + minute / 60.0;
  const bool is_day = std::chrono::year_month_day(std::chrono::year(2024), std::chrono::month(hour.month),
                                                  std::chrono::day(hour.day))
                          .ok();
  if (!is_read || !is_day || minute > 59 || !(hour.hour > 0.0 && hour.hour <= 24.0))
    throw UsageError(fmt::format(
        "--hour: expected month, day and hour, 1 to 24, such as 03-21T13 for 12 to 13 h, not '{}'", text));
  return hour;
}

double OutsideLight::direct_horizontal_illuminance() const {
  return sun ? direct_normal_illuminance.value_or(0.0) * std::max(0.0, sun->direction.z) : 0.0;
}

double OutsideLight::zenith_luminance() const {
  const auto horizontal = relative_illuminances(model).horizontal;
  return horizontal_illuminance * model.relative_luminance({0.0, 0.0, 1.0}) / horizontal;
}

void OutsideSettings::declare_sun(OptionSet& set) {
  set.heading("Sun");
  set.add_text("sun", "ELEV,AZ", sun,
               "the sun's elevation above the horizon and its azimuth from north through east, in degrees");
  set.add_text("date", "TIME", date,
               "the sun of a date and time such as 2026-03-21T12:00+01:00 or ...Z; needs --place");
  set.add_text("place", "LAT,LON", place, "latitude north and longitude east, in degrees");
  set.add_text("timezone", "hours", timezone,
               "hours east of UTC, for a --date without a time zone, such as 5.5 or +05:30");
  Declaration file{"weather", "FILE", "a weather file, EPW or WEA: the sun and the light of its --hour",
                   [this](const std::string& text) { weather = text; }, [this] { return weather; }};
  file.endings = ".epw .wea";
  set.add(std::move(file));
  set.add_text("hour", "MM-DDTHH", hour,
               "the hour of the weather file that ends at this local standard time, 1 to 24: 03-21T13 is the "
               "mean from 12 to 13 h");
}

void OutsideSettings::declare_sky(OptionSet& set) {
  set.heading("Sky");
  add_number_or_auto(set,
                     {"sky-illuminance", "lx",
                      "illuminance of the ground by the sky alone; auto: 10,000 lx, and of perez and weather "
                      "files their own",
                      sky_illuminance, 0.0, max_illuminance});
  set.add_number("albedo", "fraction", albedo, 0.0, 1.0, "diffuse reflectance of the ground");
  add_number_or_auto(set,
                     {"direct-normal", "W/m²",
                      "perez: irradiance by the sun of a plane that faces it; auto: 0, and of weather files "
                      "their own",
                      direct_normal, 0.0, 2000.0});
  add_number_or_auto(set, {"diffuse-horizontal", "W/m²",
                           "perez: irradiance of the ground by the sky; auto: that of the weather file",
                           diffuse_horizontal, 0.0, 2000.0});
  add_number_or_auto(set,
                     {"dew-point", "°C",
                      "perez: dew point of the air, which sets the luminous efficacies; auto: 11 °C, and of "
                      "weather files their own",
                      dew_point, -90.0, 60.0});
}

std::optional<SunPosition> OutsideSettings::find_sun() const {
  if (!sun.empty()) {
    const auto [elevation, azimuth] = parse_two("sun", sun, "30,180", {90.0, -360.0, 720.0});
    SunPosition position;
    position.elevation = elevation;
    position.azimuth = azimuth - 360.0 * std::floor(azimuth / 360.0);
    position.direction = direction_towards(elevation, azimuth);
    return position;
  }
  if (date.empty()) return std::nullopt;
  if (place.empty()) throw UsageError("--date needs --place: latitude and longitude, such as 52.5,13.4");
  const auto [latitude, longitude] = parse_two("place", place, "52.5,13.4", {90.0, -180.0, 180.0});
  const auto time = usage_of("date", [&] { return parse_civil_time(date); });
  std::optional<double> zone;
  if (!timezone.empty()) zone = usage_of("timezone", [&] { return parse_timezone(timezone); });
  if (!time.timezone && !zone)
    throw UsageError(fmt::format(
        "--date: '{}' has no time zone: add it, as in {}+01:00 or {}Z, or use --timezone", date, date, date));
  if (time.timezone && zone && *time.timezone != *zone)
    throw UsageError(fmt::format("--date has the time zone {:+g} h, and --timezone has {:+g} h: use one",
                                 *time.timezone, *zone));
  return sun_position(instant_of(time, zone), {latitude, longitude});
}

std::optional<ChosenHour> OutsideSettings::find_record() const {
  if (weather.empty()) return std::nullopt;
  const auto when = parse_hour_of_year(hour);
  ChosenHour chosen{load_weather(weather)};
  const auto index = find_hour(chosen.weather, when.month, when.day, when.hour);
  if (!index)
    throw UsageError(fmt::format("--hour: {} has no record of month {}, day {}, {:g} h", weather, when.month,
                                 when.day, when.hour));
  chosen.index = *index;
  return chosen;
}

void OutsideSettings::check_use(const std::string& kind) const {
  const auto refuse_both = [](const char* a, bool has_a, const char* b, bool has_b) {
    if (has_a && has_b) throw UsageError(fmt::format("--{} and --{} both place the sun: use one", a, b));
  };
  refuse_both("sun", !sun.empty(), "date", !date.empty());
  refuse_both("sun", !sun.empty(), "weather", !weather.empty());
  refuse_both("date", !date.empty(), "weather", !weather.empty());
  if (weather.empty() && !hour.empty()) throw UsageError("--hour needs --weather, the file that has it");
  if (!weather.empty() && hour.empty()) throw UsageError("--weather needs --hour, such as 03-21T13");
  if (!place.empty() && date.empty()) throw UsageError("--place needs --date; --weather has its own place");
  if (!timezone.empty() && date.empty()) throw UsageError("--timezone needs --date");
  for (const auto& [option, is_given] : {std::pair("direct-normal", direct_normal.has_value()),
                                         std::pair("diffuse-horizontal", diffuse_horizontal.has_value()),
                                         std::pair("dew-point", dew_point.has_value())}) {
    if (!is_given) continue;
    if (kind != "perez") throw UsageError(fmt::format("--{} is used with perez only", option));
    if (!weather.empty()) throw UsageError(fmt::format("--{}: the weather file has its own", option));
  }
  if (kind == "perez" && weather.empty() && !diffuse_horizontal)
    throw UsageError(
        "perez needs the irradiances --diffuse-horizontal and --direct-normal, or --weather and --hour");
}

OutsideLight OutsideSettings::daylight(const std::string& kind) const {
  OutsideLight light;
  light.kind = kind;
  light.cie_type = cie_type_of(kind);
  if (light.cie_type == 0 && kind != "uniform" && kind != "perez")
    throw UsageError(
        fmt::format("expected a sky: cie:1 to cie:{}, uniform or perez, not '{}'", sky_types, kind));
  check_use(kind);
  light.albedo = albedo;
  light.horizontal_illuminance = sky_illuminance.value_or(default_sky_illuminance);
  light.sun = find_sun();
  light.hour = find_record();
  if (light.hour) {
    light.sun = sun_of(light.hour->weather, light.hour->index);
    light.perez = perez_sky(light.hour->weather, light.hour->index, *light.sun);
  } else if (kind == "perez") {
    if (!light.sun) throw UsageError("perez needs the sun: --sun ELEV,AZ, or --date and --place");
    light.perez = perez_sky({direct_normal.value_or(0.0), diffuse_horizontal.value_or(0.0),
                             dew_point.value_or(PerezInput().dew_point), light.sun->orbit_factor()},
                            light.sun->direction);
    if (light.sun->elevation < 0.0) light.perez->direct_normal_illuminance = 0.0;
  }
  if (light.perez) {
    if (!sky_illuminance) light.horizontal_illuminance = light.perez->diffuse_illuminance;
    light.direct_normal_illuminance = light.perez->direct_normal_illuminance;
  }
  if (kind == "perez") light.model = light.perez->model;
  if (light.cie_type == 0) return light;
  light.model = SkyModel::cie(light.cie_type, light.sun ? light.sun->direction : Vec3d(0.0, 0.0, 1.0));
  if (!light.model.follows_sun()) return light;
  if (!light.sun)
    throw UsageError(
        fmt::format("{} needs the sun: --sun ELEV,AZ, --date and --place, or --weather and --hour", kind));
  if (light.sun->elevation < 0.0)
    throw UsageError(
        fmt::format("{}: the sun is {:.2f} degrees below the horizon, where this sky is not "
                    "defined; types 1, 3, 5 and 16 do not depend on the sun",
                    kind, -light.sun->elevation));
  return light;
}

}  // namespace luxel
