// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace luxel {

// The words of a name in lower case. They end at other characters than letters, and before a capital:
// "CeilingLight.001" has "ceiling" and "light". A run of capitals is one word: "LED".
std::vector<std::string> words_of(std::string_view name);

}  // namespace luxel
