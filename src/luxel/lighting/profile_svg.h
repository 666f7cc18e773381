// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "luxel/lighting/calculation_plane.h"
#include "luxel/lighting/plane_svg.h"

namespace luxel {

// Illuminance over the distance along a line, with its points and, dashed, the minimum that is required: a
// whole <svg> element, as isolux_svg().
std::string profile_svg(const PlaneResult& result, const PlaneDrawing& drawing);

}  // namespace luxel
