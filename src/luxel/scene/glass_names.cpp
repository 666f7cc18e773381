// SPDX-License-Identifier: Apache-2.0
#include "luxel/scene/glass_names.h"

#include <algorithm>
#include <array>
#include <string>

#include "luxel/scene/name_words.h"

namespace luxel {
namespace {

constexpr auto anywhere =
    std::to_array<std::string_view>({"glass", "glazing", "glas", "verglasung", "verre", "vitrage", "vidrio",
                                     "vetro", "pane", "panes", "windowpane", "windowglass"});
constexpr auto at_end = std::to_array<std::string_view>({"window", "windows", "fenster"});
constexpr auto not_glass = std::to_array<std::string_view>({"frame", "sill", "rahmen"});

template <typename List>
bool has(const List& list, const std::string& word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

}  // namespace

bool is_glass_name(std::string_view name) {
  const auto words = words_of(name);
  if (words.empty() ||
      std::any_of(words.begin(), words.end(), [](const auto& word) { return has(not_glass, word); }))
    return false;
  return has(at_end, words.back()) ||
         std::any_of(words.begin(), words.end(), [](const auto& word) { return has(anywhere, word); });
}

}  // namespace luxel
