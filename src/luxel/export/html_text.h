// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace luxel {

// The text as content or as a quoted attribute of HTML and XML: markup becomes entities, bytes that are not
// UTF-8 become question marks, control characters blanks.
std::string html_escaped(std::string_view text);

// A number with its interval in brackets, which stays on one line where the two do not fit beside each other.
std::string interval_cell(const std::string& text);

// RFC 4648, with padding.
std::string base64(std::string_view bytes);

// A table; cells are HTML. The first `texts` columns are aligned to the left, the others, numbers, to the
// right.
class HtmlTable {
 public:
  // head: names of the columns; empty: none.
  HtmlTable(std::vector<std::string> head, std::size_t texts) : head_(std::move(head)), texts_(texts) {}
  // is_number: of each column.
  HtmlTable(std::vector<std::string> head, std::vector<bool> is_number)
      : head_(std::move(head)), is_number_(std::move(is_number)) {}
  void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }
  // For tables of names and values, the first column being names.
  void add_if(const std::string& name, const std::string& value) {
    if (!value.empty()) add({name, value});
  }
  std::string html() const;

 private:
  std::vector<std::string> head_;
  std::size_t texts_ = 0;
  std::vector<bool> is_number_ = {};  // empty: those from the column `texts_` on
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace luxel
