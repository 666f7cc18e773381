// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "luxel/math/vector.h"

#include "showpiece/mesh.h"

namespace luxel::showpiece {

// A reading room in the evening: everything in it, with points rounded to a micrometre. The same on every
// call.
std::vector<Object> reading_room();

// From where it looks best.
struct View {
  const char* name;
  Vec3d eye, target;    // m
  double vertical_fov;  // degrees
};
std::vector<View> views();

}  // namespace luxel::showpiece
