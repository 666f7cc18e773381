// SPDX-License-Identifier: Apache-2.0
#include "luxel/scene/lamp_names.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace luxel {
namespace {

constexpr auto anywhere =
    std::to_array<std::string_view>({"bulb", "bulbs", "downlight", "downlights", "emission", "emissive",
                                     "emit", "emitter", "fluorescent", "glow", "lamp", "lamps", "leuchte",
                                     "led", "luminaire", "luminaires", "neon", "spotlight", "spotlights"});
constexpr auto at_end = std::to_array<std::string_view>({"light", "lights", "licht", "lumiere"});

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_capital(char c) { return c >= 'A' && c <= 'Z'; }

// Lower case. A run of capitals is one word: "LED".
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

template <typename List>
bool has(const List& list, const std::string& word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

}  // namespace

bool is_lamp_name(std::string_view name) {
  const auto words = words_of(name);
  if (words.empty()) return false;
  return has(at_end, words.back()) ||
         std::any_of(words.begin(), words.end(), [](const auto& word) { return has(anywhere, word); });
}

}  // namespace luxel
