// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/csv_table.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "luxel/core/error.h"
#include "luxel/import/numbers.h"

namespace luxel {

std::vector<std::string> csv_fields(std::string_view text, char separator,
                                    const std::function<void(const std::string& sentence)>& refuse) {
  std::vector<std::string> result;
  for (;;) {
    text = trim(text);
    std::string field;
    if (text.starts_with('"')) {
      std::size_t i = 1;
      for (;; ++i) {
        if (i >= text.size()) {
          refuse("a double quote is not closed");
          return result;
        }
        if (text[i] != '"') {
          field += text[i];
        } else if (i + 1 < text.size() && text[i + 1] == '"') {
          field += text[i++];
        } else {
          break;
        }
      }
      text = trim(text.substr(i + 1));
      if (!text.empty() && text.front() != separator)
        refuse(fmt::format("expected '{}' after a closing quote, found '{}'", separator, excerpt(text)));
    } else {
      field = trim(text.substr(0, text.find(separator)));
    }
    result.push_back(field);
    const auto end = text.find(separator);
    if (end == std::string_view::npos) return result;
    text.remove_prefix(end + 1);
  }
}

CsvTable::CsvTable(const std::filesystem::path& path, std::span<const std::string_view> known)
    : source_(path.string()), content_(read_text(path, source_)), lines_(content_) {
  if (!next_line())
    refuse(fmt::format("expected a line with the names of columns: {}", fmt::join(known, ", ")));
  const auto head = lines_.text();
  if (head.find(',') == std::string_view::npos && head.find(';') != std::string_view::npos) separator_ = ';';
  for (const auto& field : fields(head)) {
    names_.push_back(lower_case(field));
    const auto& name = names_.back();
    if (std::find(known.begin(), known.end(), name) == known.end())
      refuse(
          fmt::format("there is no column '{}'; expected some of {}", excerpt(name), fmt::join(known, ", ")));
    if (std::count(names_.begin(), names_.end(), name) > 1)
      refuse(fmt::format("the column '{}' is named twice", name));
  }
}

bool CsvTable::next_line() {
  while (lines_.next()) {
    line_ = lines_.line();
    const auto content = trim(lines_.text());
    if (!content.empty() && content.front() != '#') return true;
  }
  return false;
}

bool CsvTable::next() {
  if (!next_line()) return false;
  row_ = fields(lines_.text());
  if (row_.size() != names_.size())
    refuse(fmt::format("expected {} fields ({}), found {}", names_.size(), fmt::join(names_, ", "),
                       row_.size()));
  return true;
}

std::optional<std::size_t> CsvTable::column_of(std::string_view name) const {
  const auto at = std::find(names_.begin(), names_.end(), name);
  if (at == names_.end()) return std::nullopt;
  return static_cast<std::size_t>(at - names_.begin());
}

std::string CsvTable::text(std::string_view name) const {
  const auto column = column_of(name);
  return column ? row_[*column] : std::string();
}

std::optional<double> CsvTable::number(std::string_view name) const {
  const auto field = text(name);
  if (field.empty()) return std::nullopt;
  const auto value = read_precise_number(field);
  if (!value) refuse(fmt::format("expected a number for {}, found '{}'", name, excerpt(field)));
  return value;
}

double CsvTable::required_number(std::string_view name) const {
  const auto value = number(name);
  if (!value) refuse(fmt::format("expected a number for {}, found nothing", name));
  return *value;
}

std::optional<std::array<double, 3>> CsvTable::three_numbers(
    const std::array<std::string_view, 3>& names) const {
  std::array<double, 3> values{};
  std::size_t given = 0;
  for (std::size_t i = 0; i < 3; ++i)
    if (const auto value = number(names[i])) {
      values[i] = *value;
      ++given;
    }
  if (given == 0) return std::nullopt;
  if (given < 3) refuse(fmt::format("expected numbers for all of {}, or for none", fmt::join(names, ", ")));
  return values;
}

void CsvTable::refuse(const std::string& sentence) const { throw InputError(source_, line_, sentence); }

}  // namespace luxel
