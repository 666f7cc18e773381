// SPDX-License-Identifier: Apache-2.0
#include "luxel/load/text.h"

#include <algorithm>

#include "luxel/file/output_file.h"
#include "luxel/report/error.h"

namespace luxel {
namespace {

constexpr std::string_view blanks = " \t\v\f";

// Windows programs write UTF-16 when asked for "Unicode"; the pair FF FE opens UTF-32 little-endian as well.
bool has_wide_mark(std::string_view bytes) {
  using namespace std::string_view_literals;
  return bytes.starts_with("\xFF\xFE"sv) || bytes.starts_with("\xFE\xFF"sv) ||
         bytes.starts_with("\0\0\xFE\xFF"sv);
}

}  // namespace

std::string read_text(const std::filesystem::path& path, const std::string& source) {
  auto bytes = read_file(path);
  if (has_wide_mark(bytes))
    throw InputError(source, "expected UTF-8 text, found UTF-16 or UTF-32; save it as UTF-8");
  if (const auto zero = bytes.find('\0'); zero != std::string::npos) {
    const auto line = 1 + std::count(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(zero), '\n');
    throw InputError(source, static_cast<std::size_t>(line),
                     "expected text, found a zero byte; the file is binary or damaged");
  }
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.erase(0, 3);
  return bytes;
}

std::string_view Statements::take_line() {
  const auto end = rest_.find_first_of("\r\n");
  const auto line = rest_.substr(0, end);
  if (end == std::string_view::npos) {
    rest_ = {};
  } else {
    const bool pair = rest_[end] == '\r' && end + 1 < rest_.size() && rest_[end + 1] == '\n';
    rest_.remove_prefix(end + (pair ? 2 : 1));
  }
  ++lines_taken_;
  return line;
}

bool Statements::next() {
  if (rest_.empty()) return false;
  text_ = take_line();
  line_ = lines_taken_;
  if (trim(text_).starts_with('#')) return true;
  while (text_.ends_with('\\') && !rest_.empty()) {
    text_.back() = ' ';
    text_ += take_line();
  }
  return true;
}

std::string_view trim(std::string_view text) {
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string_view after_first_word(std::string_view text) {
  take_word(text);
  return trim(text);
}

std::string_view take_word(std::string_view& text) {
  const auto first = std::min(text.find_first_not_of(blanks), text.size());
  const auto end = std::min(text.find_first_of(blanks, first), text.size());
  const auto word = text.substr(first, end - first);
  const auto next = std::min(text.find_first_not_of(blanks, end), text.size());
  text.remove_prefix(next);
  return word;
}

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (auto& c : lower)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return lower;
}

}  // namespace luxel
