// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/page_arrays.h"

#include <bit>

#include <fmt/format.h>

namespace luxel {

static_assert(std::endian::native == std::endian::little, "a page's numbers are little-endian, as ours are");

void PageArrays::add(std::string_view name, const std::vector<float>& values) {
  append(name, "f32", values.data(), values.size(), sizeof(float));
}

void PageArrays::add(std::string_view name, const std::vector<std::uint32_t>& values) {
  append(name, "u32", values.data(), values.size(), sizeof(std::uint32_t));
}

void PageArrays::add(std::string_view name, const std::vector<std::uint16_t>& values) {
  append(name, "f16", values.data(), values.size(), sizeof(std::uint16_t));
}

void PageArrays::add(std::string_view name, const std::vector<std::uint8_t>& values) {
  append(name, "u8", values.data(), values.size(), 1);
}

void PageArrays::append(std::string_view name, std::string_view type, const void* from, std::size_t count,
                        std::size_t size) {
  const auto* bytes = static_cast<const char*>(from);
  for (std::size_t b = 0; b < size; ++b)
    for (std::size_t i = 0; i < count; ++i) bytes_ += bytes[i * size + b];
  list_.push_back({{"name", name}, {"type", type}, {"count", count}});
}

std::string page_json(const Json& value) {
  std::string text;
  for (const char c : json_text(value))  // outside of strings, JSON has none of these
    if (c == '<' || c == '>' || c == '&')
      text += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    else
      text += c;
  return text;
}

}  // namespace luxel
