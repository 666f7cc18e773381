// SPDX-License-Identifier: Apache-2.0
#include "luxel/scene/name_words.h"

namespace luxel {
namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_capital(char c) { return c >= 'A' && c <= 'Z'; }

}  // namespace

std::vector<std::string> words_of(std::string_view name) {
  std::vector<std::string> words;
  bool in_word = false;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const auto c = name[i];
    if (!is_letter(c)) {
      in_word = false;
      continue;
    }
    const bool begins = !in_word || (is_capital(c) && !is_capital(name[i - 1]));
    if (begins) words.emplace_back();
    words.back() += is_capital(c) ? static_cast<char>(c - 'A' + 'a') : c;
    in_word = true;
  }
  return words;
}

}  // namespace luxel
