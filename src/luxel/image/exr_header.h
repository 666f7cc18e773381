// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace luxel {

// OpenEXR allocates what an attribute of a header states, up to 2 GiB, before it reads the value, and takes
// the length of most types for granted. This checks that every attribute is as long as its type and inside
// the file, and that the picture is not too large for it (OpenEXR, "OpenEXR File Layout"). Throws CodecError.
// Whatever else is wrong is left to OpenEXR.
void check_exr_header(std::string_view bytes);

}  // namespace luxel
