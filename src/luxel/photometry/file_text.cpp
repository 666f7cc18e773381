// SPDX-License-Identifier: Apache-2.0
#include "luxel/photometry/file_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/core/text_lines.h"

namespace luxel {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f' || c == '\0'; }

// Code points of the bytes 0x80 to 0x9F in Windows-1252; 0: none.
constexpr std::array<unsigned, 32> windows_1252 = {
    0x20AC, 0,      0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021, 0x02C6, 0x2030, 0x0160,
    0x2039, 0x0152, 0,      0x017D, 0,      0,      0x2018, 0x2019, 0x201C, 0x201D, 0x2022,
    0x2013, 0x2014, 0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0,      0x017E, 0x0178};

void append_code_point(std::string& text, unsigned code) {
  if (code < 0x80) {
    text += static_cast<char>(code);
  } else if (code < 0x800) {
    text += static_cast<char>(0xC0 | code >> 6);
    text += static_cast<char>(0x80 | (code & 0x3F));
  } else {
    text += static_cast<char>(0xE0 | code >> 12);
    text += static_cast<char>(0x80 | (code >> 6 & 0x3F));
    text += static_cast<char>(0x80 | (code & 0x3F));
  }
}

// Number of bytes of the UTF-8 character at the start of a text; 0: there is none.
std::size_t utf8_length(std::string_view text) {
  const auto first = static_cast<unsigned char>(text[0]);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((static_cast<unsigned char>(text[i]) & 0xC0) != 0x80) return 0;
  const auto second = static_cast<unsigned char>(text[1]);
  const bool is_overlong = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
  const bool is_surrogate = first == 0xED && second >= 0xA0;
  const bool is_beyond = first == 0xF4 && second >= 0x90;
  return is_overlong || is_surrogate || is_beyond ? 0 : length;
}

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const auto length = utf8_length(text);
    if (length == 0) return false;
    text.remove_prefix(length);
  }
  return true;
}

}  // namespace

std::vector<std::string_view> split_lines(std::string_view bytes) {
  return text_lines(bytes.substr(0, bytes.find('\x1A')));
}

std::string_view without_blanks(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

std::string upper_case(std::string_view text) {
  std::string upper(text);
  for (auto& c : upper)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return upper;
}

std::string name_of(std::string_view bytes) {
  bytes = without_blanks(bytes);
  const bool is_unicode = is_utf8(bytes);
  std::string text;
  for (const auto c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7F)
      text += ' ';
    else if (byte < 0x80 || is_unicode)
      text += c;
    else if (byte >= 0xA0)
      append_code_point(text, byte);
    else if (const auto code = windows_1252[byte - 0x80]; code != 0)
      append_code_point(text, code);
  }
  return text;
}

std::string excerpt_of(std::string_view text) {
  constexpr std::size_t most = 40;  // bytes
  text = without_blanks(text);
  return text.size() <= most ? name_of(text) : name_of(text.substr(0, most)) + "...";
}

std::optional<double> number_of(std::string_view word) {
  if (word.starts_with('+')) {
    word.remove_prefix(1);
    if (word.starts_with('-')) return std::nullopt;
  }
  double value = 0.0;
  const auto* end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (error == std::errc::result_out_of_range && stop == end && word.find_first_of("eE") != word.npos &&
      word.find("-", 1) != word.npos)
    return 0.0;  // too small for a double
  if (error != std::errc() || stop != end || !(std::abs(value) <= 1e30)) return std::nullopt;
  return value;
}

std::string_view take_word(std::string_view& text, bool commas) {
  const auto separates = [commas](char c) { return is_blank(c) || (commas && (c == ',' || c == ';')); };
  std::size_t first = 0;
  while (first < text.size() && separates(text[first])) ++first;
  auto end = first;
  while (end < text.size() && !separates(text[end])) ++end;
  const auto word = text.substr(first, end - first);
  text.remove_prefix(end);
  return word;
}

void PhotometrySource::warn(std::size_t line, const std::string& sentence) {
  result.warnings.push_back(fmt::format("{}:{}: {}", file, line, sentence));
}

Numbers::Numbers(const std::string& file, const std::vector<std::string_view>& lines, std::size_t first)
    : file_(file), lines_(lines), next_line_(first), line_(first) {}

// Moves to the line with the next word, which rest_ then begins with.
bool Numbers::find_word() {
  for (;;) {
    auto rest = rest_;
    if (!take_word(rest, true).empty()) return true;
    if (next_line_ >= lines_.size()) return false;
    rest_ = lines_[next_line_++];
    line_ = next_line_;
  }
}

bool Numbers::at_end() { return !find_word(); }

double Numbers::next(std::string_view what) {
  if (!find_word()) throw InputError(file_, line_, fmt::format("the file ends where {} should be", what));
  const auto word = take_word(rest_, true);
  const auto value = number_of(word);
  if (!value)
    throw InputError(file_, line_, fmt::format("expected {}, a number, found '{}'", what, excerpt_of(word)));
  return *value;
}

std::size_t Numbers::next_count(std::string_view what, std::size_t low, std::size_t high) {
  const auto value = next(what);
  if (!(value >= static_cast<double>(low) && value <= static_cast<double>(high)) ||
      value != std::floor(value))
    throw InputError(
        file_, line_,
        fmt::format("expected {}, a whole number from {} to {}, found {:g}", what, low, high, value));
  return static_cast<std::size_t>(value);
}

std::vector<double> read_angles(Numbers& numbers, const std::string& file, std::size_t count,
                                std::string_view kind) {
  std::vector<double> angles;
  for (std::size_t i = 0; i < count; ++i) {
    const auto angle = numbers.next(fmt::format("{} angle {} of {}", kind, i + 1, count));
    if (std::abs(angle) > 360.0)
      throw InputError(file, numbers.line(),
                       fmt::format("expected a {} angle within 360 degrees, found {:g}", kind, angle));
    if (!angles.empty() && !(angle > angles.back()))
      throw InputError(
          file, numbers.line(),
          fmt::format("expected ascending {} angles, found {:g} after {:g}", kind, angle, angles.back()));
    angles.push_back(angle);
  }
  return angles;
}

}  // namespace luxel
