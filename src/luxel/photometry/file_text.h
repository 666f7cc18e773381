// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "luxel/photometry/photometry.h"

namespace luxel {

// Maximum number of luminous intensities of a file. The finest goniometers give 0.5 degrees in both angles,
// 361 x 720 values.
inline constexpr std::size_t max_intensities = 1'000'000;
// Maximum size of a file, bytes: that of max_intensities numbers of 16 characters.
inline constexpr std::size_t max_file_bytes = 16 * max_intensities;

// The lines of a text, which must outlive them; they end with \n, \r\n or a lone \r. A byte order mark and
// what follows an end-of-file mark (Ctrl-Z) are left out.
std::vector<std::string_view> split_lines(std::string_view bytes);

std::string_view without_blanks(std::string_view text);  // without those at both ends
std::string upper_case(std::string_view text);           // ASCII letters only

// A name in a file, as UTF-8 without blanks at its ends and without control characters: bytes that are not
// UTF-8 are Latin-1 (Windows-1252).
std::string name_of(std::string_view bytes);

// Returns as much of a text as is needed to recognise it, UTF-8.
std::string excerpt_of(std::string_view text);

// A word that is one whole number of at most 1e30, such as "1", "+2.", ".8e-1"; anything else is nothing.
std::optional<double> number_of(std::string_view word);

// The first bytes of a word list: separated by blanks, and by commas and semicolons where `commas`.
std::string_view take_word(std::string_view& text, bool commas);

// A file being read: its name, its lines, and the data read so far.
struct PhotometrySource {
  std::string file;
  std::vector<std::string_view> lines;
  Photometry result;

  // line: from 1.
  void warn(std::size_t line, const std::string& sentence);
};

// Numbers that follow each other on lines, separated by blanks and commas; a record may span lines.
class Numbers {
 public:
  // first: index of the line to begin with. Both must outlive it.
  Numbers(const std::string& file, const std::vector<std::string_view>& lines, std::size_t first);

  // The next number. Throws InputError where the file ends or has something else; what: names it in messages.
  double next(std::string_view what);
  // The next number, which must be whole and from `low` to `high`.
  std::size_t next_count(std::string_view what, std::size_t low, std::size_t high);
  // Returns whether no word is left.
  bool at_end();
  std::size_t line() const { return line_; }  // of the last number, from 1

 private:
  bool find_word();

  const std::string& file_;
  const std::vector<std::string_view>& lines_;
  std::size_t next_line_;  // index
  std::size_t line_;
  std::string_view rest_;
};

// `count` angles in degrees, which must ascend. Throws InputError with file and line where they do not.
std::vector<double> read_angles(Numbers& numbers, const std::string& file, std::size_t count,
                                std::string_view kind);

}  // namespace luxel
