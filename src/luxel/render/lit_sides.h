// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "luxel/patch/patch_set.h"
#include "luxel/solution/solution.h"

namespace luxel {

// What a view is judged by: how bright each side of each patch shows. Side 2 * patch is the front,
// 2 * patch + 1 the back.
struct LitSides {
  std::vector<float> brightness;  // [side], [0, 1): 0 unlit, 0.5 the scene's log-average; lamps count by what
                                  // they reflect
  double lit_area = 0.0;          // m², of all lit sides

  bool lit(std::size_t side) const { return brightness[side] > 0.0f; }
};

// Where the solution has no light, or has not been solved, every side that reflects counts as lit.
LitSides make_lit_sides(const PatchSet& patches, const Solution& solution);

}  // namespace luxel
