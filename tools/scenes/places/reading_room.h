// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scenes/shapes/mesh.h"

namespace luxel::scenes {

// A reading room in the evening: everything in it, with points rounded to a micrometre. The same on every
// call. detail: 1 or more; every triangle is cut in detail² of the same shape, so the surfaces (and the light
// on them) stay what they are: 39,884 triangles times detail².
std::vector<Object> reading_room(int detail = 1);

}  // namespace luxel::scenes
