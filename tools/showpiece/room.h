// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "luxel/core/vector.h"

#include "showpiece/mesh.h"

namespace luxel::showpiece {

// A reading room in the evening: everything in it, with points rounded to a micrometre. The same on every
// call. detail: 1 or more; every triangle is cut in detail² of the same shape, so the surfaces (and the light
// on them) stay what they are: 39,884 triangles times detail².
std::vector<Object> reading_room(int detail = 1);

// From where it looks best.
struct View {
  const char* name;
  Vec3d eye, target;    // m
  double vertical_fov;  // degrees
};
std::vector<View> views();

}  // namespace luxel::showpiece
