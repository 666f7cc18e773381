// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "luxel/photometry/file_text.h"

namespace luxel {

// Reads the TILT= line with index `line`, and the factors after it or in the file that it names; `numbers`
// moves behind them. A tilted luminaire's lamp may give less light; the factors per tilt are not in
// Photometry: returns the factor of the luminaire that is not tilted, which candela are multiplied by, and
// warns of what it leaves out. A file of factors is read only from the folder of the IES file. Throws
// InputError with file and line.
double read_tilt(PhotometrySource& source, std::size_t line, int version, Numbers& numbers);

}  // namespace luxel
