// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace luxel {

// Maximum size of a weather file, bytes: 60 records of 240 bytes per hour for a leap year.
inline constexpr std::size_t max_weather_bytes = std::size_t{128} << 20;

// The fields of a line without blanks at their ends: separated by commas, or else by blanks.
enum class Separator { comma, blank };
std::vector<std::string_view> fields_of(std::string_view line, Separator separator);

// A field that is one finite number, such as "-6.0", "+5.5" or ".2"; anything else is nothing.
std::optional<double> field_number(std::string_view field);
// A field that is a whole number within limits, such as "12" or " 1.0"; anything else is nothing.
std::optional<int> field_count(std::string_view field, int low, int high);

// At most 40 bytes of a field, without control characters.
std::string shown(std::string_view field);
// The whole of it, without control characters and blanks at its ends.
std::string cleaned(std::string_view field);

}  // namespace luxel
