// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/wrapped_text.h"

#include <algorithm>
#include <cctype>

namespace luxel {

std::size_t width_of(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

std::string wrapped(const std::string& text, const Margins& margins) {
  std::string result;
  auto used = margins.used;
  for (std::size_t begin = 0; begin < text.size();) {
    const auto end = std::min(text.find(' ', begin), text.size());
    const auto word = text.substr(begin, end - begin);
    const auto blank = begin > 0 ? 1 : 0;
    if (used + blank + width_of(word) > margins.width && used > margins.indent) {
      result += '\n' + std::string(margins.indent, ' ');
      used = margins.indent;
    } else {
      result.append(blank, ' ');
      used += blank;
    }
    result += word;
    used += width_of(word);
    begin = end + 1;
  }
  return result;
}

std::string sentence(std::string text) {
  if (text.empty()) return text;
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text.ends_with('.') ? text : text + ".";
}

}  // namespace luxel
