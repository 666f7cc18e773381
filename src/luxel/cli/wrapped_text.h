// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace luxel {

// Characters of a text in UTF-8, each one column wide.
std::size_t width_of(std::string_view text);

// Layout of a text: `used` columns of its first line are taken, all other lines begin with `indent` blanks,
// and no line is wider than `width` unless a word is.
struct Margins {
  std::size_t used = 0;
  std::size_t indent = 0;
  std::size_t width = 100;
};
std::string wrapped(const std::string& text, const Margins& margins);

// With a capital and a full stop.
std::string sentence(std::string text);

}  // namespace luxel
