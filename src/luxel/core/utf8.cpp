// SPDX-License-Identifier: Apache-2.0
#include "luxel/core/utf8.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include <fmt/format.h>

namespace luxel {
namespace {

// Length of the well-formed sequence at the beginning of the text, 0 if there is none. The ranges of the
// second byte are those of RFC 3629, section 4: no overlong forms, no surrogates, nothing above U+10FFFF.
std::size_t sequence_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
  const auto first = byte(0);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xC2 && first <= 0xDF   ? 2
                             : first >= 0xE0 && first <= 0xEF ? 3
                             : first >= 0xF0 && first <= 0xF4 ? 4
                                                              : 0;
  if (length == 0) return 0;
  const auto low = first == 0xE0 ? 0xA0u : first == 0xF0 ? 0x90u : 0x80u;
  const auto high = first == 0xED ? 0x9Fu : first == 0xF4 ? 0x8Fu : 0xBFu;
  if (byte(1) < low || byte(1) > high) return 0;
  for (std::size_t i = 2; i < length; ++i)
    if (byte(i) < 0x80 || byte(i) > 0xBF) return 0;
  return length;
}

// The code point of a well-formed sequence.
std::uint32_t code_of(std::string_view sequence) {
  const auto first = static_cast<unsigned char>(sequence[0]);
  if (sequence.size() == 1) return first;
  std::uint32_t code = first & (0xFFu >> (sequence.size() + 1));
  for (const char c : sequence.substr(1)) code = code << 6 | (static_cast<unsigned char>(c) & 0x3Fu);
  return code;
}

bool is_control(std::uint32_t code) {
  const auto is_between = [code](std::uint32_t low, std::uint32_t high) {
    return code >= low && code <= high;
  };
  return code < 0x20 || is_between(0x7F, 0x9F) || is_between(0x200E, 0x200F) || is_between(0x2028, 0x202E) ||
         is_between(0x2066, 0x2069);
}

}  // namespace

std::string printable(std::string_view text, bool keeps_lines) {
  std::string result;
  while (!text.empty()) {
    const auto length = sequence_length(text);
    const auto sequence = text.substr(0, std::max<std::size_t>(length, 1));
    const auto code = length == 0 ? static_cast<unsigned char>(text[0]) : code_of(sequence);
    const bool is_kept = keeps_lines && (code == '\n' || code == '\t');
    if (length == 0 || (code < 0x80 && is_control(code) && !is_kept))
      result += fmt::format("\\x{:02x}", code);
    else if (is_control(code) && !is_kept)
      result += fmt::format("\\u{{{:04x}}}", code);
    else
      result += sequence;
    text.remove_prefix(sequence.size());
  }
  return result;
}

std::string valid_utf8(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const auto length = sequence_length(text);
    if (length == 0)
      result += '?';
    else
      result += text.substr(0, length);
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return result;
}

}  // namespace luxel
