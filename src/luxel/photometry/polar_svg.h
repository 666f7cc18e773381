// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "luxel/photometry/photometry.h"

namespace luxel {

// The polar diagram of a luminaire as an SVG element: intensity over the angle from the aim, which is at the
// bottom, in the planes C0-C180 (C0 on the right) and C90-C270; in cd per 1000 lm of the lamps, or in cd
// where photometry is absolute. Types A and B: the horizontal and the vertical plane through the aim. The
// upper half is left out where it has no light. 360 units wide, for a white ground; without ids, style sheets
// and scripts, so that several can stand in one HTML page.
std::string polar_svg(const Photometry& photometry);

}  // namespace luxel
