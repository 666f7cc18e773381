// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace luxel {

// The text with every byte that is not UTF-8 (RFC 3629) replaced by a question mark. Names in OBJ files are
// whatever bytes their author's machine had; JSON is UTF-8 alone.
std::string valid_utf8(std::string_view text);

// Makes a text safe for terminals: names from files could hold sequences that move its cursor, change its
// title or turn the direction of writing. Bytes that are not UTF-8 and control characters (C0, C1, DEL, those
// of direction) become \xNN or \u{NNNN}; ends of lines and tabs stay where `keeps_lines`.
std::string printable(std::string_view text, bool keeps_lines = true);

}  // namespace luxel
