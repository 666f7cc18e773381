// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "luxel/photometry/weather.h"

namespace luxel {

// The readers of the two formats. lines must outlive the call.
Weather read_epw(const std::vector<std::string_view>& lines, const std::string& file);
Weather read_wea(const std::vector<std::string_view>& lines, const std::string& file);

// Returns whether a year may have this day; 29 February included.
bool is_day(unsigned month, unsigned day);

// Fills has_leap_day and the instants of the middles, from month, day, end and duration.
void date_hours(Weather& weather);

// Adds the oddities that need the sun: missing hours, a time zone far from the longitude, light by night.
void find_oddities(Weather& weather);

// Throws InputError where a place is not on the earth.
struct Header {
  double latitude, longitude, timezone, elevation;
};
void set_place(Weather& weather, std::size_t line, const Header& header);

}  // namespace luxel
