// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace luxel {

// The name that a mistyped word most likely means: that of the smallest edit distance (insertions, deletions,
// substitutions and swaps of neighbours; Damerau 1964), the first of several. Empty where all differ in more
// than a third of the letters.
std::string nearest_name(const std::string& word, const std::vector<std::string>& names);

}  // namespace luxel
