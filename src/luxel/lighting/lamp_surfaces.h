// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "luxel/patch/patch_set.h"

namespace luxel {

// Patches of one material that emit and hang together by vertices: a lamp, as a person sees it.
struct LampSurface {
  std::string name;                    // of the material
  std::vector<std::uint32_t> patches;  // ascending
};

// In the order of their first patches. Linear.
std::vector<LampSurface> find_lamp_surfaces(const PatchSet& patches);

}  // namespace luxel
