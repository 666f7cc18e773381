// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "luxel/patch/patch_set.h"
#include "luxel/patch/side.h"
#include "luxel/solution/solution.h"
#include "luxel/trace/views.h"

namespace luxel {

// The input of the choice of views: the brightness of each side of each patch. Side 2 * patch is the front, 2
// * patch + 1 the back.
struct LitSides {
  std::vector<float> brightness;  // [side], [0, 1): 0 unlit, 0.5 the irradiance typical of the scene; a
                                  // lamp shows at least as a lit wall does
  std::vector<bool> glaring;      // [side]: emits far more than lit surfaces send back
  double lit_area = 0.0;          // m², each lit side's area times its brightness

  bool lit(SideId side) const { return brightness[side.index()] > 0.0f; }
};

// Where the solution has no light, or has not been solved, every side that reflects counts as lit. What is
// typical is what views see, from where a person can be: the insides of lamp shades have most of the power of
// some rooms. Without views it is what most of the power falls on.
LitSides make_lit_sides(const PatchSet& patches, const Solution& solution, const Views& views);

}  // namespace luxel
