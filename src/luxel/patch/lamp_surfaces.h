// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "luxel/patch/patch_set.h"

namespace luxel {

// A lamp: emitting patches of one material that are connected by vertices.
struct LampSurface {
  std::string name;                    // of the material
  std::vector<std::uint32_t> patches;  // ascending
};

// In the order of their first patches. Linear.
std::vector<LampSurface> find_lamp_surfaces(const PatchSet& patches);

}  // namespace luxel
