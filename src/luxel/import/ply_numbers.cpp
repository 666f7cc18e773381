// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/ply_numbers.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/import/numbers.h"
#include "luxel/import/text.h"

namespace luxel {
namespace {

template <typename T>
double number_of(std::string_view bytes, bool is_swapped) {
  std::array<char, sizeof(T)> raw;
  std::copy_n(bytes.begin(), raw.size(), raw.begin());
  if (is_swapped) std::reverse(raw.begin(), raw.end());
  return static_cast<double>(std::bit_cast<T>(raw));
}

double number_of(std::string_view bytes, PlyType type, bool is_swapped) {
  switch (type) {
    case PlyType::i8:
      return number_of<std::int8_t>(bytes, is_swapped);
    case PlyType::u8:
      return number_of<std::uint8_t>(bytes, is_swapped);
    case PlyType::i16:
      return number_of<std::int16_t>(bytes, is_swapped);
    case PlyType::u16:
      return number_of<std::uint16_t>(bytes, is_swapped);
    case PlyType::i32:
      return number_of<std::int32_t>(bytes, is_swapped);
    case PlyType::u32:
      return number_of<std::uint32_t>(bytes, is_swapped);
    case PlyType::f32:
      return number_of<float>(bytes, is_swapped);
    case PlyType::f64:
      return number_of<double>(bytes, is_swapped);
  }
  return 0.0;
}

}  // namespace

void PlyNumbers::refuse(const std::string& message) const {
  if (is_text()) throw InputError(source_, line_, message);
  throw InputError(source_, fmt::format("at byte {}: {}", done(), message));
}

void PlyNumbers::expect(const PlyElement& element) const {
  std::size_t least = 0;  // bytes per element
  for (const auto& property : element.properties)
    least += is_text() ? 2 : size_of(property.is_list ? property.count_type : property.type);
  // Division, since the product can overflow. The last line may lack its end.
  if (least > 0 && (rest_.size() + 1) / least < element.count)
    throw InputError(
        source_, element.line,
        fmt::format("{} elements '{}' are declared, which take at least {} bytes each, but only {} "
                    "bytes are left; the file is cut off or damaged",
                    element.count, element.name, least, rest_.size()));
}

void PlyNumbers::begin_element() {
  if (!is_text()) return;
  do {
    if (rest_.empty()) refuse("the file ends before all of its elements are there");
    const auto end = std::find_if(rest_.begin(), rest_.end(), [](char c) { return c == '\n' || c == '\r'; });
    current_ = trim(std::string_view(rest_.begin(), end));
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.begin()));
    if (!rest_.empty()) rest_.remove_prefix(rest_.starts_with("\r\n") ? 2 : 1);
    ++line_;
  } while (current_.empty());
}

void PlyNumbers::end_element() const {
  if (is_text() && !current_.empty())
    refuse(fmt::format("the line has more numbers than its element: '{}' is left", excerpt(current_)));
}

std::string_view PlyNumbers::take_text() {
  const auto word = take_word(current_);
  if (word.empty()) refuse("the line has fewer numbers than its element");
  return word;
}

std::string_view PlyNumbers::take_bytes(std::size_t count) {
  if (rest_.size() < count) refuse("the file ends before all of its elements are there");
  const auto bytes = rest_.substr(0, count);
  rest_.remove_prefix(count);
  return bytes;
}

double PlyNumbers::next(PlyType type) {
  if (is_text()) return read_precise_number(take_text()).value_or(std::numeric_limits<double>::quiet_NaN());
  const bool is_little = header_.encoding == PlyEncoding::little_endian;
  return number_of(take_bytes(size_of(type)), type,
                   is_little != (std::endian::native == std::endian::little));
}

std::size_t PlyNumbers::next_count(const PlyProperty& list) {
  const auto count = next(list.count_type);
  if (!(count >= 0.0) || count != std::floor(count))
    refuse(fmt::format("expected the count of '{}', a whole number of 0 or more", list.name));
  const auto most = is_text() ? (current_.size() + 1) / 2 : rest_.size() / size_of(list.type);
  if (count > static_cast<double>(most))
    refuse(
        fmt::format("'{}' is said to have {:.0f} numbers, but at most {} are left", list.name, count, most));
  return static_cast<std::size_t>(count);
}

void PlyNumbers::skip(PlyType type) {
  if (is_text())
    take_text();
  else
    take_bytes(size_of(type));
}

}  // namespace luxel
