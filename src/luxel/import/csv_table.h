// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "luxel/import/text.h"

namespace luxel {

// The fields of one line of a CSV file, without blanks around them; a field in double quotes may contain the
// separator, and two double quotes for one. refuse: throws the error of a sentence about a wrong line.
std::vector<std::string> csv_fields(std::string_view line, char separator,
                                    const std::function<void(const std::string& sentence)>& refuse);

// A CSV file whose first line names the columns, in any order: fields are separated by commas, or by
// semicolons where the first line has no comma; a field in double quotes may contain both, and two double
// quotes for one. Empty lines and lines that begin with # are ignored. Goes through the rows one by one.
// Throws InputError with file and line where the file breaks these rules or the ones below.
class CsvTable {
 public:
  // known: the names a column may have, in lower case.
  CsvTable(const std::filesystem::path& path, std::span<const std::string_view> known);
  CsvTable(const CsvTable&) = delete;
  CsvTable& operator=(const CsvTable&) = delete;

  bool next();                                // goes to the next row; false at the end
  std::size_t line() const { return line_; }  // of the row, from 1
  const std::string& source() const { return source_; }
  bool has_column(std::string_view name) const { return column_of(name).has_value(); }
  // Returns the field of a column; empty if there is no such column.
  std::string text(std::string_view name) const;
  // Returns the number of a field, which must be finite; nothing if it is empty or there is no such column.
  std::optional<double> number(std::string_view name) const;
  double required_number(std::string_view name) const;
  // Three columns that are all given or all empty.
  std::optional<std::array<double, 3>> three_numbers(const std::array<std::string_view, 3>& names) const;
  [[noreturn]] void refuse(const std::string& sentence) const;

 private:
  bool next_line();
  std::vector<std::string> fields(std::string_view text) const {
    return csv_fields(text, separator_, [this](const std::string& sentence) { refuse(sentence); });
  }
  std::optional<std::size_t> column_of(std::string_view name) const;

  std::string source_, content_;
  Statements lines_;
  std::size_t line_ = 1;
  char separator_ = ',';
  std::vector<std::string> names_, row_;
};

}  // namespace luxel
