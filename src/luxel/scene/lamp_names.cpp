// SPDX-License-Identifier: Apache-2.0
#include "luxel/scene/lamp_names.h"

#include <algorithm>
#include <array>
#include <string>

#include "luxel/scene/name_words.h"

namespace luxel {
namespace {

constexpr auto anywhere =
    std::to_array<std::string_view>({"bulb", "bulbs", "downlight", "downlights", "emission", "emissive",
                                     "emit", "emitter", "fluorescent", "glow", "lamp", "lamps", "leuchte",
                                     "led", "luminaire", "luminaires", "neon", "spotlight", "spotlights"});
constexpr auto at_end = std::to_array<std::string_view>({"light", "lights", "licht", "lumiere"});

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
