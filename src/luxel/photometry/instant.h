// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <optional>
#include <string>

namespace luxel {

// An instant, UTC.
using Instant = std::chrono::sys_seconds;

// A date and a time as a person writes it.
struct CivilTime {
  std::chrono::sys_days day = {};       // Gregorian
  int seconds = 0;                      // since the beginning of the day, up to 86400
  std::optional<double> timezone = {};  // hours east of UTC; nothing: not written
};

// Reads an ISO 8601 date and time such as 2026-03-21T12:00+01:00, 2026-03-21T11:00Z, 2026-03-21T12:00:30+0530
// or 2026-03-21T12:00 without a time zone; seconds may be left out, 24:00 is the end of the day, and a blank
// may stand for the T. Years are 1600 to 2399. Throws InputError with what was expected.
CivilTime parse_civil_time(const std::string& text);

// Hours east of UTC in [-12, 14], as EPW, WEA and people write them: 5.5, +05:30, -6, Z. Throws InputError.
double parse_timezone(const std::string& text);

// The instant of a time in its own time zone, or in `timezone` (hours east of UTC) where it has none. Throws
// InputError where neither is known.
Instant instant_of(const CivilTime& time, std::optional<double> timezone = {});

// As "2026-03-21T12:00+01:00", in a time zone of whole minutes; seconds where they are not 0.
std::string text_of(Instant instant, double timezone);

}  // namespace luxel
