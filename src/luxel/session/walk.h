// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/patch/patch_set.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// Returns whether the side that was met sends light on.
inline bool reflects(const PatchSet& patches, const Hit& hit) {
  const auto& material = patches.material_of(hit.patch);
  if (hit.back && !material.two_sided) return false;
  if (material.is_diffuser()) return true;
  for (const auto r : material.reflectance)
    if (r > 0.0f) return true;
  return false;
}

}  // namespace luxel
