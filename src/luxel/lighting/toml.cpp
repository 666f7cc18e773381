// SPDX-License-Identifier: Apache-2.0
#include "luxel/lighting/toml.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/import/numbers.h"
#include "luxel/import/text.h"

namespace luxel {
namespace {

constexpr int max_depth = 8;  // of arrays and braces in each other

bool is_of_key(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-'; }

class TomlParser {
 public:
  TomlParser(std::string_view text, const std::string& source) : rest_(text), source_(source) {
    file_.source = source;
    file_.tables.emplace_back();
  }

  TomlFile parse() {
    for (skip_lines(); !rest_.empty(); skip_lines()) {
      if (rest_.front() == '[')
        take_header();
      else
        take_entry(file_.tables.back().entries);
      end_line();
    }
    return std::move(file_);
  }

 private:
  [[noreturn]] void refuse(const std::string& sentence) const { throw InputError(source_, line_, sentence); }

  char peek() const { return rest_.empty() ? '\n' : rest_.front(); }
  bool take(char c) {
    if (rest_.empty() || rest_.front() != c) return false;
    rest_.remove_prefix(1);
    return true;
  }
  void skip_blanks() {
    while (peek() == ' ' || peek() == '\t') rest_.remove_prefix(1);
  }
  // Comments and line ends, too.
  void skip_lines() {
    for (;;) {
      skip_blanks();
      if (peek() == '#') rest_.remove_prefix(std::min(rest_.find('\n'), rest_.size()));
      if (rest_.starts_with("\r\n")) rest_.remove_prefix(1);
      if (!take('\n')) return;
      ++line_;
    }
  }
  void end_line() {
    skip_blanks();
    if (!rest_.empty() && peek() != '#' && peek() != '\n' && !rest_.starts_with("\r\n"))
      refuse(fmt::format("expected the end of the line, found '{}'", excerpt(line_rest())));
  }
  std::string_view line_rest() const { return rest_.substr(0, rest_.find('\n')); }

  std::string take_key() {
    skip_blanks();
    if (peek() == '"' || peek() == '\'') return take_text();
    std::size_t length = 0;
    while (length < rest_.size() && is_of_key(rest_[length])) ++length;
    if (length == 0) refuse(fmt::format("expected a key, found '{}'", excerpt(line_rest())));
    std::string key(rest_.substr(0, length));
    rest_.remove_prefix(length);
    return key;
  }

  void take_header() {
    TomlTable table{.name = {}, .line = line_};
    take('[');
    table.is_element = take('[');
    do {
      if (!table.name.empty()) table.name += '.';
      table.name += take_key();
      skip_blanks();
    } while (take('.'));
    if (!take(']') || (table.is_element && !take(']')))
      refuse(fmt::format("expected {} after '{}'", table.is_element ? "]]" : "]", table.name));
    for (const auto& other : file_.tables)
      if (other.name == table.name && !(other.is_element && table.is_element))
        refuse(fmt::format("there is a table [{}] in line {} already", table.name, other.line));
    file_.tables.push_back(std::move(table));
  }

  void take_entry(TomlEntries& entries) {
    const auto line = line_;
    auto key = take_key();
    skip_blanks();
    if (peek() == '.')
      refuse(
          fmt::format("expected = after '{0}', found a dot: write {0} = {{ ... }}, or a header [{0}]", key));
    if (!take('=')) refuse(fmt::format("expected = after '{}', found '{}'", key, excerpt(line_rest())));
    for (const auto& other : entries)
      if (other.key == key) refuse(fmt::format("'{}' is set in line {} already", key, other.value.line));
    auto value = take_value(0);
    value.line = line;
    entries.push_back({std::move(key), std::move(value)});
  }

  TomlValue take_value(int depth) {
    skip_blanks();
    if (depth > max_depth) refuse(fmt::format("expected at most {} brackets in each other", max_depth));
    switch (peek()) {
      case '"':
      case '\'':
        return {take_text(), line_};
      case '[':
        return take_array(depth);
      case '{':
        return take_braces();
      default:
        return take_word();
    }
  }

  std::string take_text() {
    const auto quote = peek();
    if (rest_.starts_with("\"\"\"") || rest_.starts_with("'''"))
      refuse("expected text on one line, between two \" or two '");
    take(quote);
    std::string text;
    while (!take(quote)) {
      if (peek() == '\n') refuse(fmt::format("expected {} at the end of the text", quote));
      auto c = rest_.front();
      rest_.remove_prefix(1);
      if (c == '\\' && quote == '"') c = take_escape();
      text += c;
    }
    return text;
  }

  char take_escape() {
    const auto c = peek();
    const std::string_view from = "\"\\nt", to = "\"\\\n\t";
    const auto found = from.find(c);
    if (found == std::string_view::npos)
      refuse(fmt::format("expected one of \\\" \\\\ \\n \\t, found \\{}", c));
    take(c);
    return to[found];
  }

  TomlValue take_array(int depth) {
    const auto line = line_;
    take('[');
    TomlArray array;
    for (skip_lines(); !take(']'); skip_lines()) {
      if (rest_.empty()) throw InputError(source_, line, "expected ] at the end of the list");
      array.push_back(take_value(depth + 1));
      skip_lines();
      if (!rest_.empty() && !take(',') && peek() != ']')
        refuse(fmt::format("expected a comma or ] in the list, found '{}'", excerpt(line_rest())));
    }
    return {std::move(array), line};
  }

  TomlValue take_braces() {
    take('{');
    TomlEntries entries;
    skip_blanks();
    while (!take('}')) {
      take_entry(entries);
      skip_blanks();
      if (!take(',') && peek() != '}')
        refuse(fmt::format("expected a comma or }} on the line of its {{, found '{}'", excerpt(line_rest())));
      skip_blanks();
    }
    return {std::move(entries), line_};
  }

  TomlValue take_word() {
    std::size_t length = 0;
    while (length < rest_.size() &&
           (is_of_key(rest_[length]) || rest_[length] == '+' || rest_[length] == '.'))
      ++length;
    std::string word(rest_.substr(0, length));
    if (word == "true" || word == "false") {
      rest_.remove_prefix(length);
      return {word == "true", line_};
    }
    auto digits = word;
    digits.erase(std::remove(digits.begin(), digits.end(), '_'), digits.end());
    const auto number = read_precise_number(digits);
    if (!number)
      refuse(fmt::format("expected a number, true, false, or text between \" and \", found '{}'",
                         excerpt(line_rest())));
    rest_.remove_prefix(length);
    return {*number, line_};
  }

  std::string_view rest_;
  const std::string& source_;
  std::size_t line_ = 1;
  TomlFile file_;
};

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const auto& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

}  // namespace

TomlFile parse_toml(std::string_view text, const std::string& source) {
  return TomlParser(text, source).parse();
}

TomlFile read_toml(const std::string& file) { return parse_toml(read_text(file, file), file); }

TomlKeys::TomlKeys(const std::string& source, const TomlTable& table, const std::vector<std::string>& known)
    : TomlKeys(source, table.entries, table.line, known) {}

TomlKeys::TomlKeys(const std::string& source, const TomlEntries& entries, std::size_t line,
                   const std::vector<std::string>& known)
    : source_(source), entries_(entries), line_(line) {
  check(known);
}

void TomlKeys::check(const std::vector<std::string>& known) const {
  for (const auto& [key, value] : entries_)
    if (std::find(known.begin(), known.end(), key) == known.end())
      throw InputError(source_, value.line,
                       fmt::format("there is no key '{}' here; expected one of {}", key, joined(known)));
}

const TomlValue* TomlKeys::find(std::string_view key) const {
  for (const auto& entry : entries_)
    if (entry.key == key) return &entry.value;
  return nullptr;
}

std::size_t TomlKeys::line(std::string_view key) const {
  const auto* value = find(key);
  return value != nullptr ? value->line : line_;
}

void TomlKeys::refuse(std::string_view key, const std::string& sentence) const {
  throw InputError(source_, line(key), key.empty() ? sentence : fmt::format("{}: {}", key, sentence));
}

std::optional<std::string> TomlKeys::text(std::string_view key) const {
  const auto* value = find(key);
  if (value == nullptr) return std::nullopt;
  const auto* text = std::get_if<std::string>(&value->value);
  if (text == nullptr) refuse(key, "expected text between \" and \"");
  if (text->empty()) refuse(key, "expected text between \" and \", found none");
  return *text;
}

std::optional<bool> TomlKeys::flag(std::string_view key) const {
  const auto* value = find(key);
  if (value == nullptr) return std::nullopt;
  const auto* flag = std::get_if<bool>(&value->value);
  if (flag == nullptr) refuse(key, "expected true or false");
  return *flag;
}

double TomlKeys::finite_number(std::string_view key, const TomlValue& value) const {
  const auto* number = std::get_if<double>(&value.value);
  if (number == nullptr) refuse(key, "expected a number");
  return *number;
}

std::optional<double> TomlKeys::number(std::string_view key, double min, double max) const {
  const auto* value = find(key);
  if (value == nullptr) return std::nullopt;
  const auto number = finite_number(key, *value);
  if (!(number >= min && number <= max))
    refuse(key, fmt::format("expected a number from {} to {}, found {}", min, max, number));
  return number;
}

std::vector<double> TomlKeys::list(std::string_view key, const TomlValue& value) const {
  const auto* array = std::get_if<TomlArray>(&value.value);
  if (array == nullptr) refuse(key, "expected a list of numbers such as [0, 0, 0.75]");
  std::vector<double> numbers;
  for (const auto& element : *array) numbers.push_back(finite_number(key, element));
  return numbers;
}

std::optional<std::vector<double>> TomlKeys::numbers(std::string_view key, std::size_t size) const {
  const auto* value = find(key);
  if (value == nullptr) return std::nullopt;
  auto numbers = list(key, *value);
  if (size > 0 && numbers.size() != size)
    refuse(key, fmt::format("expected {} numbers in brackets, found {}", size, numbers.size()));
  return numbers;
}

std::optional<Vec3d> TomlKeys::point(std::string_view key) const {
  const auto numbers = this->numbers(key, 3);
  if (!numbers) return std::nullopt;
  return Vec3d((*numbers)[0], (*numbers)[1], (*numbers)[2]);
}

std::optional<std::vector<std::vector<double>>> TomlKeys::rows(std::string_view key) const {
  const auto* value = find(key);
  if (value == nullptr) return std::nullopt;
  const auto* array = std::get_if<TomlArray>(&value->value);
  if (array == nullptr) refuse(key, "expected a list of points such as [[0, 0], [4, 0], [4, 3]]");
  std::vector<std::vector<double>> rows;
  for (const auto& element : *array) rows.push_back(list(key, element));
  return rows;
}

const TomlEntries* TomlKeys::table(std::string_view key) const {
  const auto* value = find(key);
  return value == nullptr ? nullptr : std::get_if<TomlEntries>(&value->value);
}

}  // namespace luxel
