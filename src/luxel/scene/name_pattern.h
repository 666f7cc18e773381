// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace luxel {

// True where the whole name matches: * stands for any run of characters, ? for exactly one, everything else
// for itself. Costs at most pattern length times name length.
bool matches(std::string_view pattern, std::string_view name);

}  // namespace luxel
