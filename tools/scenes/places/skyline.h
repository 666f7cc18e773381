// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenes/shapes/mesh.h"

namespace luxel::scenes {

// What one sees from the window: an evening sky over a town, as layers of open sheets that face +z, centred
// at the origin; the sky lies in the plane z = 0, the town in front of it.
Mesh evening_sky(double width, double height);
Mesh town(double width, double height);         // dark houses
Mesh lit_windows(double width, double height);  // in the houses of the near row, shining

}  // namespace luxel::scenes
