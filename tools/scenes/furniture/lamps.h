// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenes/shapes/mesh.h"

namespace luxel::scenes {

// A lamp is a stand and what shines: a closed bulb and, where there is one, an open shade of cloth that glows
// outwards and reflects inwards. Every shining face looks outwards.
struct Lamp {
  Mesh stand;  // closed
  Mesh bulb;   // closed
  Mesh shade;  // open; empty where there is none
};

Lamp floor_lamp();    // stands at the origin, 1.62 m high, arched towards +z
Lamp table_lamp();    // stands at the origin, 0.50 m high
Lamp pendant_lamp();  // hangs from the origin, 1.25 m down
Lamp globe_lamp();    // hangs from the origin, 0.45 m down: an opal globe of 25 cm

}  // namespace luxel::scenes
