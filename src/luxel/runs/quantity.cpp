// SPDX-License-Identifier: Apache-2.0
#include "luxel/runs/quantity.h"

#include <cmath>
#include <span>
#include <string_view>

#include <fmt/format.h>

#include "luxel/runs/option_set.h"
#include "luxel/session/words.h"

namespace luxel {
namespace {

struct Unit {
  std::string_view name;
  double size;
};
constexpr Unit time_units[] = {{"s", 1.0}, {"min", 60.0}, {"h", 3600.0}};
constexpr double mebibyte = 1024.0 * 1024.0;
constexpr double gibibyte = 1024.0 * mebibyte;
constexpr Unit memory_units[] = {{"MiB", mebibyte}, {"GiB", gibibyte}};

std::optional<double> with_unit(const std::string& text, std::span<const Unit> units) {
  for (const auto& unit : units) {
    if (!text.ends_with(unit.name)) continue;
    const auto number = parse_double(text.substr(0, text.size() - unit.name.size()));
    if (number) return *number * unit.size;
  }
  return std::nullopt;
}

}  // namespace

std::optional<double> parse_fraction(const std::string& text) {
  // Moves the decimal point in the text, so that 1.3 % and 0.013 are bitwise the same number.
  const auto fraction = text.ends_with('%') ? parse_double(text.substr(0, text.size() - 1) + "e-2")  //
                                            : parse_double(text);
  if (!fraction || !(*fraction >= 0.0 && *fraction < 1.0)) return std::nullopt;
  return fraction;
}

std::string as_fraction(double fraction) { return fmt::format("{:.15g}%", 100.0 * fraction); }

std::optional<double> parse_duration(const std::string& text) {
  constexpr double longest = 1e9;
  auto seconds = with_unit(text, time_units);
  if (!seconds) seconds = parse_double(text);
  if (!seconds || !(*seconds > 0.0 && *seconds < longest)) return std::nullopt;
  return seconds;
}

std::string as_duration(double seconds) { return fmt::format("{}s", seconds); }

std::optional<std::uint64_t> parse_bytes(const std::string& text) {
  constexpr double most = 1e15;
  const auto bytes = with_unit(text, memory_units);
  if (!bytes || !(*bytes >= mebibyte && *bytes < most)) return std::nullopt;
  return static_cast<std::uint64_t>(std::llround(*bytes));
}

std::string as_bytes(std::uint64_t bytes) {
  const auto number = static_cast<double>(bytes);
  return number < gibibyte ? fmt::format("{}MiB", number / mebibyte)
                           : fmt::format("{}GiB", number / gibibyte);
}

std::string rough_duration(double seconds) {
  if (seconds < 1.0) return "1 s";
  if (seconds < 120.0) return fmt::format("{:.0f} s", seconds);
  if (seconds < 7200.0) return fmt::format("{:.0f} min", seconds / 60.0);
  if (seconds < 172'800.0) return fmt::format("{:.0f} h", seconds / 3600.0);
  return fmt::format("{:.0f} days", seconds / 86'400.0);
}

std::string rough_bytes(std::uint64_t bytes) {
  const auto number = static_cast<double>(bytes);
  return number < gibibyte ? fmt::format("{:.0f} MiB", std::ceil(number / mebibyte))
                           : fmt::format("{:.1f} GiB", number / gibibyte);
}

std::string rough_count(std::uint64_t count) {
  const auto number = static_cast<double>(count);
  if (number >= 1e9) return fmt::format("{:.3g} billion", 1e-9 * number);
  if (number >= 1e6) return fmt::format("{:.3g} million", 1e-6 * number);
  return with_commas(count);
}

std::string taken_time(double seconds) {
  if (seconds < 10.0) return fmt::format("{:.2g} s", seconds);
  if (seconds < 100.0) return fmt::format("{:.1f} s", seconds);
  const auto whole = static_cast<long>(std::llround(seconds));
  if (whole < 6000) return fmt::format("{} min {} s", whole / 60, whole % 60);
  return fmt::format("{} h {} min", whole / 3600, whole % 3600 / 60);
}

bool is_known_error(double error) { return error > 0.0 && error <= 1.0; }

std::string percent_of(double fraction) {
  constexpr double two_digits = 0.995;  // beyond it {:.2g} writes an exponent
  return fraction < two_digits ? fmt::format("{:.2g} %", 100.0 * fraction)
                               : fmt::format("{:.0f} %", 100.0 * fraction);
}

std::string error_text(double error) { return is_known_error(error) ? percent_of(error) : "not yet known"; }

}  // namespace luxel
