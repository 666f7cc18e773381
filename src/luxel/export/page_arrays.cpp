// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/page_arrays.h"

#include <vector>

#include <fmt/format.h>

namespace luxel {

void PageArrays::add_differences(std::string_view name, std::span<const std::int32_t> values,
                                 std::size_t stride) {
  std::vector<std::uint32_t> codes(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    // Differences wrap around, so that any two numbers have one.
    const auto before = stride > 0 && i >= stride ? static_cast<std::uint32_t>(values[i - stride]) : 0u;
    const auto difference = static_cast<std::uint32_t>(values[i]) - before;
    codes[i] = difference << 1u ^ (difference >> 31u ? ~0u : 0u);
  }
  for (unsigned shift = 0; shift < 32; shift += 8)
    for (const auto code : codes) bytes_ += static_cast<char>(code >> shift & 0xffu);
  list_.push_back({{"name", name}, {"type", "i32"}, {"count", values.size()}, {"stride", stride}});
}

void PageArrays::add(std::string_view name, std::span<const std::uint8_t> values) {
  bytes_.append(reinterpret_cast<const char*>(values.data()), values.size());
  list_.push_back({{"name", name}, {"type", "u8"}, {"count", values.size()}});
}

void PageArrays::add_file(std::string_view name, std::string_view bytes) {
  bytes_ += bytes;
  list_.push_back({{"name", name}, {"type", "u8"}, {"count", bytes.size()}});
}

std::string page_json(const Json& value) {
  std::string text;
  for (const char c : json_text(value))  // JSON has these characters only inside strings
    if (c == '<' || c == '>' || c == '&')
      text += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    else
      text += c;
  return text;
}

}  // namespace luxel
