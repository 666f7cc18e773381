// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenes/shapes/mesh.h"

namespace luxel::scenes {

// All closed, standing at the origin. Metres.

Mesh coffee_table();  // 1.15 x 0.62, top at coffee_table_height
Mesh side_table();    // round, 0.46, top at side_table_height
Mesh sideboard();     // 1.60 x 0.42, front towards +z, top at sideboard_height
Mesh rug();           // 2.6 x 1.9, long side along x, 12 mm thick

inline constexpr double coffee_table_height = 0.40;
inline constexpr double side_table_height = 0.52;
inline constexpr double sideboard_height = 0.74;
inline constexpr double rug_height = 0.012;

// Things that stand about on tables.
Mesh vase(Paint glaze, double height);  // slim, closed at the top of its neck
Mesh bellied_vase(Paint glaze, double height);
Mesh bowl(Paint glaze, double radius);
Mesh fruit_bowl(Paint glaze);  // with seven oranges
Mesh lying_books(std::uint64_t which, int count);
Mesh mug(Paint glaze);

}  // namespace luxel::scenes
