// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/text.h"

#include <algorithm>

#include "luxel/core/error.h"
#include "luxel/core/output_file.h"

namespace luxel {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
bool is_not_blank(char c) { return !is_blank(c); }
bool ends_line(char c) { return c == '\n' || c == '\r'; }

// Windows programs write UTF-16 for "Unicode"; UTF-32 little-endian begins with FF FE as well.
bool has_wide_mark(std::string_view bytes) {
  using namespace std::string_view_literals;
  return bytes.starts_with("\xFF\xFE"sv) || bytes.starts_with("\xFE\xFF"sv) ||
         bytes.starts_with("\0\0\xFE\xFF"sv);
}

}  // namespace

std::string read_text(const std::filesystem::path& path, const std::string& source) {
  return text_of(read_file(path), source);
}

std::string text_of(std::string bytes, const std::string& source) {
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

// std::find_if, here and below: string_view::find_first_of, which searches its set for each character, took a
// third of the loading time.
std::string_view Statements::take_line() {
  const auto end = std::find_if(rest_.begin(), rest_.end(), ends_line);
  const auto length = static_cast<std::size_t>(end - rest_.begin());
  const auto line = rest_.substr(0, length);
  rest_.remove_prefix(length);
  if (!rest_.empty()) rest_.remove_prefix(rest_.starts_with("\r\n") ? 2 : 1);
  ++lines_taken_;
  return line;
}

bool Statements::next() {
  if (rest_.empty()) return false;
  text_ = take_line();
  line_ = lines_taken_;
  if (text_.ends_with('\\') && !trim(text_).starts_with('#')) join_lines();
  return true;
}

void Statements::join_lines() {
  joined_ = text_;
  while (joined_.ends_with('\\') && !rest_.empty()) {
    joined_.back() = ' ';
    joined_ += take_line();
  }
  text_ = joined_;
}

std::string_view trim(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

std::string_view take_word(std::string_view& text) {
  const auto first = std::find_if(text.begin(), text.end(), is_not_blank);
  const auto end = std::find_if(first, text.end(), is_blank);
  const auto next = std::find_if(end, text.end(), is_not_blank);
  const std::string_view word(first, end);
  text = std::string_view(next, text.end());
  return word;
}

std::string excerpt(std::string_view text) {
  constexpr std::size_t most = 60;
  text = trim(text);
  return text.size() <= most ? std::string(text) : std::string(text.substr(0, most)) + "...";
}

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (auto& c : lower)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return lower;
}

}  // namespace luxel
