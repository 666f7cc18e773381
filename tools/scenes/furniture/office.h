// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "scenes/shapes/mesh.h"

namespace luxel::scenes {

// All closed, in metres, standing at the origin unless it says otherwise.

Mesh office_desk();              // 1.6 x 0.8, top at desk_height; one sits at +z and looks towards -z
Mesh office_chair(Paint cloth);  // facing +z, on a star of five
Mesh monitor();                  // its foot at the origin, its screen towards +z and shining
Mesh keyboard();                 // 0.44 x 0.13
Mesh paper_stack(std::uint64_t which);
Mesh filing_cabinet(Paint body);                            // 0.8 x 0.45 x 1.2, drawers towards +z
Mesh partition(double length, double height, Paint cloth);  // along x
Mesh waste_bin();

// A luminaire of 1.2 x 0.6 m set into the ceiling: its lower edge hangs 20 mm below y = 0.
Mesh ceiling_luminaire_housing();
Mesh ceiling_luminaire_panel(Paint lamp);  // open: it shines downwards

inline constexpr double desk_height = 0.74;

}  // namespace luxel::scenes
