// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "luxel/scene/scene.h"

namespace luxel::bench {

// The scenes that accuracy is measured on, made in code and cut regularly into about `triangles` triangles
// (within a few per cent from 2,000 on), to be solved without further cuts (no_max_edge). Always the same.

// scenes/cornell-box.obj: its places, paints and lamp. Open at the front, 0.55 m.
Scene cornell_box(std::size_t triangles);

// A closed office, 12 x 9 x 2.8 m: twelve luminaires of two triangles each under the ceiling, facing down,
// and under each a desk with a chair, all of boxes.
Scene office(std::size_t triangles);

// Two closed rooms of 4 x 3.6 x 2.6 m and an open doorway between them; the only lamp hangs in the first,
// aside of the door: nearly all light of the second room has been reflected on its way.
Scene two_rooms(std::size_t triangles);

// The room that `luxel-scenes reading-room` writes: 39,884 triangles times detail².
Scene reading_room(int detail);

}  // namespace luxel::bench
