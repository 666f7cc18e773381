// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/photometry/file_text.h"

namespace luxel {

// Returns whether lines are those of a EULUMDAT file: numbers where its header has them.
bool is_eulumdat(const std::vector<std::string_view>& lines);

// Fills source.result from EULUMDAT lines. Throws InputError with file and line.
void read_eulumdat(PhotometrySource& source, const PhotometryOptions& options);

}  // namespace luxel
