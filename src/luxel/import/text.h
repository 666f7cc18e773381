// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace luxel {

// The text of a file, without a UTF-8 byte order mark. Throws InputError naming `source` where the file
// cannot be read, is UTF-16 or UTF-32, or is binary (holds a zero byte).
std::string read_text(const std::filesystem::path& path, const std::string& source);

// Returns the text of a file's bytes.
std::string text_of(std::string bytes, const std::string& source);

// Walks a text statement by statement. Lines end with \n, \r\n or a lone \r and count from 1; a backslash at
// the end of a line joins the next one to it (not in comments: "# made in C:\" must not swallow a line).
class Statements {
 public:
  // The text must outlive it.
  explicit Statements(std::string_view text) : rest_(text) {}

  // Goes to the next one, false at the end. Empty lines and comments come too.
  bool next();
  std::string_view text() const { return text_; }    // without its line end; until next()
  std::size_t line() const { return line_; }         // where it begins
  std::size_t left() const { return rest_.size(); }  // characters behind it

 private:
  std::string_view take_line();
  void join_lines();

  std::string_view rest_;
  std::string_view text_;
  std::string joined_;  // what text_ shows of a statement of several lines
  std::size_t line_ = 0;
  std::size_t lines_taken_ = 0;
};

std::string_view trim(std::string_view text);
// Removes the first word (blanks around it too) from text and returns it; empty where there is none.
std::string_view take_word(std::string_view& text);
// Returns as much of a text as is needed to recognise a line.
std::string excerpt(std::string_view text);
std::string lower_case(std::string_view text);

}  // namespace luxel
