// SPDX-License-Identifier: Apache-2.0
#include "luxel/patch/check_light.h"

#include "luxel/report/error.h"

namespace luxel {

void check_light(const PatchSet& patches) {
  if (patches.has_sky() || !patches.point_lights.empty()) return;
  for (std::size_t p = 0; p < patches.size(); ++p)
    if (patches.material_of(p).is_lamp()) return;
  throw InputError(
      "the scene has no lamp: give a material a 'Ke R G B' line (radiance, W/(m² sr)) in its MTL file, and "
      "use that material on at least one face; or let in light from all around with --sky 1");
}

}  // namespace luxel
