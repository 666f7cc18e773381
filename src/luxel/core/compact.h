// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace luxel {

// The bytes made smaller: a zlib stream (RFC 1950), as browsers read it by the name "deflate". The same bytes
// from the same version of zlib. Throws DeviceError where memory is short.
std::string deflated(std::string_view bytes);

// The bytes as text (RFC 4648, section 4): letters, digits, + and /, ends in = where it must.
std::string base64(std::string_view bytes);

}  // namespace luxel
