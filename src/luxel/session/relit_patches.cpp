// SPDX-License-Identifier: Apache-2.0
#include "luxel/session/relit_patches.h"

#include "luxel/solve/own_lighting.h"

namespace luxel {

PatchSet relit_patches(PatchSet patches, const Lighting& lighting) {
  const OwnLighting own(patches);
  if (!lighting.lamps.empty()) own.set_lamps(lighting.lamps, patches);
  if (!lighting.reflectance.empty()) own.set_reflectance(lighting.reflectance, patches);
  return patches;
}

}  // namespace luxel
