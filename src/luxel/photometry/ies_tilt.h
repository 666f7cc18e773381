// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "luxel/photometry/file_text.h"

namespace luxel {

// Reads the TILT= line with index `line`, and the factors after it or in the file that it names; `numbers`
// moves behind them. A tilted luminaire's lamp may give less light, but Photometry has no factors per tilt:
// returns the factor of the luminaire that is not tilted, by which candela are multiplied, and warns of
// ignored factors. A file of factors is read only from the folder of the IES file. Throws InputError with
// file and line.
double read_tilt(PhotometrySource& source, std::size_t line, int version, Numbers& numbers);

}  // namespace luxel
