// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "luxel/core/vector.h"

namespace luxel {

struct TomlValue;
using TomlArray = std::vector<TomlValue>;
struct TomlEntry;
using TomlEntries = std::vector<TomlEntry>;

struct TomlValue {
  std::variant<std::string, double, bool, TomlArray, TomlEntries> value;
  std::size_t line = 0;
};

struct TomlEntry {
  std::string key;
  TomlValue value;
};

// The keys under one header: [name] or [[name]].
struct TomlTable {
  std::string name;         // "area", "requirement.writing"; empty: the keys before the first header
  bool is_element = false;  // [[name]], of which there may be several
  std::size_t line = 1;
  TomlEntries entries = {};
};

// A file in a strict subset of TOML 1.0: comments, headers with dots, text in "" (escapes \" \\ \n \t) or '',
// numbers, true and false, arrays over several lines, and tables in braces. Refused: dates, text over several
// lines, keys with dots, numbers in other bases, and infinities.
struct TomlFile {
  std::string source;             // for messages
  std::vector<TomlTable> tables;  // in the order of the file; the first one has no name
};

// Throws InputError with file and line.
TomlFile parse_toml(std::string_view text, const std::string& source);
TomlFile read_toml(const std::string& file);

// Typed access to the keys of one table. All throw InputError with file and line where a value is of another
// kind or out of its range.
class TomlKeys {
 public:
  // Keeps references. Throws InputError where the table has a key that is not `known`.
  TomlKeys(const std::string& source, const TomlTable& table, const std::vector<std::string>& known);
  // The keys of a table in braces.
  TomlKeys(const std::string& source, const TomlEntries& entries, std::size_t line,
           const std::vector<std::string>& known);

  bool has(std::string_view key) const { return find(key) != nullptr; }
  std::optional<std::string> text(std::string_view key) const;  // not empty
  std::optional<bool> flag(std::string_view key) const;
  std::optional<double> number(std::string_view key, double min, double max) const;
  // A list of `size` numbers; 0: of any number of them.
  std::optional<std::vector<double>> numbers(std::string_view key, std::size_t size = 0) const;
  std::optional<Vec3d> point(std::string_view key) const;
  // A list of lists of numbers.
  std::optional<std::vector<std::vector<double>>> rows(std::string_view key) const;
  // The entries of a table in braces; null where the key is absent or its value is something else.
  const TomlEntries* table(std::string_view key) const;

  // The line of a key, or that of the table.
  std::size_t line(std::string_view key = {}) const;
  const std::string& source() const { return source_; }
  [[noreturn]] void refuse(std::string_view key, const std::string& sentence) const;

 private:
  const TomlValue* find(std::string_view key) const;
  void check(const std::vector<std::string>& known) const;
  double finite_number(std::string_view key, const TomlValue& value) const;
  std::vector<double> list(std::string_view key, const TomlValue& value) const;

  const std::string& source_;
  const TomlEntries& entries_;
  std::size_t line_;
};

}  // namespace luxel
