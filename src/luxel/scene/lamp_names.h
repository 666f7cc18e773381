// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace luxel {

// Returns whether a material's name is that of a lamp: one of its words is "lamp", "bulb", "luminaire" and
// the like, or its last word is "light". Words end at other characters than letters, and before a capital:
// "CeilingLight", "bulb.001". "light wood" and "LightGrey" are not lamps.
bool is_lamp_name(std::string_view name);

}  // namespace luxel
