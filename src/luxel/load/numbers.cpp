// SPDX-License-Identifier: Apache-2.0
#include "luxel/load/numbers.h"

#include <charconv>
#include <cmath>
#include <limits>

#include "luxel/load/text.h"

namespace luxel {

std::optional<float> read_number(std::string_view word) {
  if (word.starts_with('+')) {
    word.remove_prefix(1);
    if (word.starts_with('-')) return std::nullopt;
  }
  // By way of double, so that what underflows a float (1e-40 is common in exported matrices) is not refused.
  double value = 0.0;
  const auto end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (error != std::errc() || stop != end) return std::nullopt;
  if (!(std::abs(value) <= std::numeric_limits<float>::max())) return std::nullopt;
  return static_cast<float>(value);
}

std::optional<Vec3> read_three_numbers(std::string_view text) {
  Vec3 v;
  for (int i = 0; i < 3; ++i) {
    const auto number = read_number(take_word(text));
    if (!number) return std::nullopt;
    v[i] = *number;
  }
  return v;
}

}  // namespace luxel
