// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/suggestion.h"

#include <algorithm>

namespace luxel {
namespace {

std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> before_last, last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] != b[j - 1] ? 1 : 0)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
    before_last = last;
    last = row;
  }
  return last[b.size()];
}

}  // namespace

std::string nearest_name(const std::string& word, const std::vector<std::string>& names) {
  std::string nearest;
  auto smallest = std::max<std::size_t>(1, word.size() / 3) + 1;
  for (const auto& name : names)
    if (const auto distance = edit_distance(word, name); distance < smallest) {
      smallest = distance;
      nearest = name;
    }
  return nearest;
}

}  // namespace luxel
