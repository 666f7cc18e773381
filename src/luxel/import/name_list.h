// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

namespace luxel {

// Names for a sentence: 'a', 'b', 'c' and 12 more.
std::string name_list(std::span<const std::string> names);

// "1 face", "5 faces".
std::string counted(std::size_t count, const char* noun);

}  // namespace luxel
