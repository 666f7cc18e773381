// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace luxel {

// Returns whether a material's name is that of window glass: one of its words is "glass", "glazing", "pane"
// and the like, or its last word is "window". "window frame" and "fibreglass" are not.
bool is_glass_name(std::string_view name);

}  // namespace luxel
