// SPDX-License-Identifier: Apache-2.0
#include "luxel/photometry/table_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace luxel {
namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f' || c == '\0'; }

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return text;
}

}  // namespace

std::vector<std::string_view> fields_of(std::string_view line, Separator separator) {
  std::vector<std::string_view> fields;
  if (separator == Separator::comma) {
    for (;;) {
      const auto end = std::min(line.find(','), line.size());
      fields.push_back(trimmed(line.substr(0, end)));
      if (end == line.size()) return fields;
      line.remove_prefix(end + 1);
    }
  }
  for (line = trimmed(line); !line.empty(); line = trimmed(line)) {
    const auto end = std::find_if(line.begin(), line.end(), is_space) - line.begin();
    fields.push_back(line.substr(0, static_cast<std::size_t>(end)));
    line.remove_prefix(static_cast<std::size_t>(end));
  }
  return fields;
}

std::optional<double> field_number(std::string_view field) {
  if (field.starts_with('+') && !field.starts_with("+-")) field.remove_prefix(1);
  double value = 0.0;
  const auto* end = field.data() + field.size();
  const auto [stop, error] = std::from_chars(field.data(), end, value);
  if (error != std::errc() || stop != end || !(std::abs(value) <= 1e30)) return std::nullopt;
  return value;
}

std::optional<int> field_count(std::string_view field, int low, int high) {
  const auto value = field_number(field);
  if (!value || !(*value >= low && *value <= high) || *value != std::floor(*value)) return std::nullopt;
  return static_cast<int>(*value);
}

std::string cleaned(std::string_view field) {
  std::string text(trimmed(field));
  for (auto& c : text)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = ' ';
  return text;
}

std::string shown(std::string_view field) {
  constexpr std::size_t max_bytes = 40;
  field = trimmed(field);
  return field.size() <= max_bytes ? cleaned(field) : cleaned(field.substr(0, max_bytes)) + "...";
}

}  // namespace luxel
