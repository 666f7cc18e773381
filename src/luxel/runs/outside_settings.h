// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "luxel/photometry/perez_sky.h"
#include "luxel/photometry/sky_integrals.h"
#include "luxel/photometry/sun_position.h"
#include "luxel/photometry/weather.h"
#include "luxel/runs/option_set.h"

namespace luxel {

// An hour of a weather file: "2026-03-21T13", "03-21T13" or "03-21T12:30"; the year is ignored. It is the
// record whose interval holds this time or ends at it.
struct HourOfYear {
  unsigned month = 1, day = 1;
  double hour = 1.0;  // (0, 24]
};
// Throws UsageError.
HourOfYear parse_hour_of_year(const std::string& text);

// A record of a weather file, and where it is.
struct ChosenHour {
  Weather weather;  // without oddities that were reported
  std::size_t index = 0;
  const WeatherHour& record() const { return weather.hours[index]; }
};

// Sun and sky outside, from the command line.
struct OutsideLight {
  std::string kind;  // "uniform", "cie:12" or "perez"
  int cie_type = 0;  // 0: not of the CIE
  SkyModel model;
  double horizontal_illuminance = 0.0;  // by the sky, lx
  double albedo = 0.2;                  // of the ground
  std::optional<SunPosition> sun;
  std::optional<double> direct_normal_illuminance;  // by the sun, lx, where it is known
  std::optional<PerezSky> perez;
  std::optional<ChosenHour> hour;

  double direct_horizontal_illuminance() const;  // lx; 0 where it is not known
  double zenith_luminance() const;               // cd/m²
};

inline constexpr double default_sky_illuminance = 10'000.0;  // lx

// Position of the sun, brightness of the sky, and the light of a weather file.
struct OutsideSettings {
  std::string sun, date, place, timezone;  // as typed; empty: not given
  std::string weather, hour;
  std::optional<double> sky_illuminance;  // lx; nothing: default_sky_illuminance, or the sky's own
  double albedo = 0.2;
  std::optional<double> direct_normal, diffuse_horizontal;  // W/m²
  std::optional<double> dew_point;                          // °C

  void declare_sun(OptionSet& set);
  void declare_sky(OptionSet& set);

  // The daylight of a kind of sky: "uniform", "cie:1" to "cie:16", "perez". Throws UsageError where options
  // are missing, contradict each other or are wrong; InputError of a wrong weather file.
  OutsideLight daylight(const std::string& kind) const;

 private:
  std::optional<SunPosition> find_sun() const;
  std::optional<ChosenHour> find_record() const;
  void check_use(const std::string& kind) const;
};

}  // namespace luxel
