// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/image/image.h"
#include "luxel/runs/outside_settings.h"

namespace luxel {

// All directions in cd/m², equirectangular: 1024 x 512 pixels; azimuths from north at the left edge through
// east, south in the middle and west; the zenith at the top, the ground below the middle. Without the sun's
// disc.
Image sky_panorama(const OutsideLight& light);

// The dome in false colours, display-referred: zenith in the middle, radius proportional to the angle from
// it, north at the top and east on the right as on a map; circles at elevations of 30 and 60 degrees, a ring
// at the sun, and a legend in cd/m².
Image sky_dome(const OutsideLight& light);

}  // namespace luxel
