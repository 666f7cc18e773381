// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace luxel {

// The page without a scene: the bundle of web/ that was built with this program (cmake/luxel_page.cmake).
// Empty where Node.js or its packages were missing then.
std::string_view page_template();
// The reason for an empty template, as one line; else empty.
std::string_view page_obstacle();

}  // namespace luxel
