// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <functional>
#include <string>

#include <fmt/format.h>

#include "luxel/photometry/sun_position.h"

namespace luxel {

// A year of weather that tests make.
struct MadeWeather {
  Site site = {28.6, 77.2};  // Delhi, whose time zone has half an hour
  double timezone = 5.5;
  double written_timezone = 5.5, written_longitude = 77.2;  // as the file has them
  int per_hour = 1;
  bool has_leap_day = false;
  double shift = 0.0;  // h: the light is that of the sun later by this
  bool has_illuminances = true;
  bool is_in_watts = false;  // records of a part of an hour have W/m²
};

// W/m²: 800 by the sun where it is above the horizon, and 100 by the sky.
struct MadeLight {
  double direct = 0.0, diffuse = 0.0, global = 0.0;
};

inline MadeLight made_light(const SunPosition& sun) {
  if (sun.elevation < 0.0) return {};
  return {800.0, 100.0, 100.0 + 800.0 * sun.direction.z};
}

// The same light as EPW, by the sun in the middle of each record.
inline std::string made_epw(const MadeWeather& made) {
  std::string text = fmt::format(
      "LOCATION,New Delhi,-,IND,made,000000,{:g},{:g},{:g},216.0\nDESIGN CONDITIONS,0\n"
      "TYPICAL/EXTREME PERIODS,0\nGROUND TEMPERATURES,0\nHOLIDAYS/DAYLIGHT SAVINGS,{},0,0,0\n"
      "COMMENTS 1,made by a test\nCOMMENTS 2,\nDATA PERIODS,1,{},Data,Sunday, 1/ 1,12/31\n",
      made.site.latitude, made.written_longitude, made.written_timezone, made.has_leap_day ? "Yes" : "No",
      made.per_hour);
  const std::chrono::year year(made.has_leap_day ? 2024 : 2023);
  const std::chrono::sys_days begin = year / std::chrono::January / 1,
                              end = year / std::chrono::December / 31;
  for (auto day = begin; day <= end; day += std::chrono::days(1)) {
    const std::chrono::year_month_day date(day);
    for (int record = 0; record < 24 * made.per_hour; ++record) {
      const auto middle = (record + 0.5) / made.per_hour - made.timezone + made.shift;
      const auto instant = Instant(day) + std::chrono::seconds(std::lround(3600.0 * middle));
      const auto light = made_light(sun_position(instant, made.site));
      const auto energy = made.is_in_watts ? 1.0 : 1.0 / made.per_hour;  // Wh/m² per W/m²
      // Years as in a typical year: a different year for each month.
      text += fmt::format("{},{},{},{},{},?9?9?9,20.0,10.0,50,99000,0,0,300,{:.3f},{:.3f},{:.3f}",
                          1990 + static_cast<int>(static_cast<unsigned>(date.month())),
                          static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                          record / made.per_hour + 1, (record % made.per_hour + 1) * 60 / made.per_hour,
                          energy * light.global, energy * light.direct, energy * light.diffuse);
      text +=
          made.has_illuminances
              ? fmt::format(",{:.0f},{:.0f},{:.0f},2000,0,0\n", 110.0 * light.global, 100.0 * light.direct,
                            120.0 * light.diffuse * (1.0 + 0.1 * static_cast<unsigned>(date.month())))
              : ",999999,999999,999999,9999,0,0\n";
    }
  }
  return text;
}

}  // namespace luxel
