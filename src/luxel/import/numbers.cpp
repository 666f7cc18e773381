// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/numbers.h"

#include <charconv>
#include <cmath>
#include <limits>

#include "luxel/import/text.h"

namespace luxel {

std::optional<double> read_precise_number(std::string_view word) {
  if (word.starts_with('+')) {
    word.remove_prefix(1);
    if (word.starts_with('-')) return std::nullopt;
  }
  double value = 0.0;
  const auto end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (error != std::errc() || stop != end) return std::nullopt;
  if (!(std::abs(value) <= std::numeric_limits<float>::max())) return std::nullopt;
  return value;
}

// Parses as double, so that a value that underflows a float (1e-40 is common in exported matrices) is not
// refused.
std::optional<float> read_number(std::string_view word) {
  const auto number = read_precise_number(word);
  return number ? std::optional(static_cast<float>(*number)) : std::nullopt;
}

std::optional<Vec3d> read_three_precise_numbers(std::string_view text) {
  Vec3d v;
  for (int i = 0; i < 3; ++i) {
    const auto number = read_precise_number(take_word(text));
    if (!number) return std::nullopt;
    v[i] = *number;
  }
  return v;
}

std::optional<Vec3> read_three_numbers(std::string_view text) {
  const auto numbers = read_three_precise_numbers(text);
  return numbers ? std::optional(Vec3(*numbers)) : std::nullopt;
}

}  // namespace luxel
