// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "luxel/photometry/photometry.h"

namespace luxel {

// The same as load_photometry() from the bytes of a file; `file` names it in messages, and a TILT= file is
// looked for in its folder.
Photometry read_photometry(std::string_view bytes, const std::string& file,
                           const PhotometryOptions& options = {});

}  // namespace luxel
