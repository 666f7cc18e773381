// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace luxel {

// Compresses bytes to a zlib stream (RFC 1950), which browsers call "deflate". The same bytes from the same
// version of zlib. Throws DeviceError where memory is short.
std::string deflated(std::string_view bytes);

// The bytes as text, five characters for four bytes: digits, letters and punctuation that HTML leaves as they
// are (no <, &, quotes or backslash). Up to three bytes of zeros are added at the end, to make whole groups.
std::string base85(std::string_view bytes);

}  // namespace luxel
