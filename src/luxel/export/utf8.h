// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace luxel {

// The text with every byte that is not UTF-8 (RFC 3629) replaced by a question mark. Names in OBJ files are
// whatever bytes their author's machine had; JSON is UTF-8 alone.
std::string valid_utf8(std::string_view text);

}  // namespace luxel
