// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenes/shapes/mesh.h"

namespace luxel::scenes {

// A bookcase, its back at z = 0, open towards +z, centred in x: 1.9 m wide, 2.2 m high, 0.32 m deep, five
// shelves of two bays.
Mesh bookcase();

// The books in it, and the vases between them.
Mesh books_of_bookcase();

// One book standing at the origin, its rounded spine towards +z. size: thickness, height, depth. which
// chooses its colour.
Mesh standing_book(std::uint64_t which, const Vec3d& size);

}  // namespace luxel::scenes
