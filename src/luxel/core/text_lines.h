// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

namespace luxel {

// The lines of a text, which must outlive them; they end with \n, \r\n or a lone \r. A byte order mark is
// left out.
std::vector<std::string_view> text_lines(std::string_view bytes);

}  // namespace luxel
