// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace luxel {

// Conversion of numbers with units from and to text: the text of as_... is parsed to the same number. Nothing
// where the text is not such a number.

// "1%" or "0.01": 0 to below 1. A bare 1, which could be either, is none.
std::optional<double> parse_fraction(const std::string& text);
std::string as_fraction(double fraction);

// "30s", "5min", "2h", "30" (seconds): above 0, in seconds.
std::optional<double> parse_duration(const std::string& text);
std::string as_duration(double seconds);

// "512MiB", "4GiB": at least 1 MiB, in bytes.
std::optional<std::uint64_t> parse_bytes(const std::string& text);
std::string as_bytes(std::uint64_t bytes);

// For a person to read: "3 s", "50 min", "7 h", "12 days"; "300 MiB", "74.5 GiB".
std::string rough_duration(double seconds);
std::string rough_bytes(std::uint64_t bytes);
// "850", "12,400", "3.4 million", "1.2 billion".
std::string rough_count(std::uint64_t count);
// For a finished run: "0.42 s", "12.3 s", "50 min 10 s".
std::string taken_time(double seconds);

// "1.9 %". An error above 100 % is a number without use: the light is not known yet.
bool is_known_error(double error);
std::string percent_of(double fraction);
std::string error_text(double error);  // "1.9 %", or "not yet known"

}  // namespace luxel
