// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/photometry/file_text.h"

namespace luxel {

// Returns whether lines are those of an IES LM-63 file: a version's name at the start, or a TILT= line.
bool is_ies(const std::vector<std::string_view>& lines);

// Fills source.result from IES LM-63 lines. Throws InputError with file and line.
void read_ies(PhotometrySource& source);

}  // namespace luxel
