// SPDX-License-Identifier: Apache-2.0
#include "luxel/patch/check_light.h"

#include "luxel/core/error.h"
#include "luxel/core/hint.h"

namespace luxel {

void check_light(const PatchSet& patches) {
  if (patches.has_sky() || !patches.point_lights.empty()) return;
  for (std::size_t p = 0; p < patches.size(); ++p)
    if (patches.material_of(p).is_lamp()) return;
  throw with_hints(
      InputError(
          "the scene has no lamp: give a material emission (OBJ: a line 'Ke R G B' in its MTL file, radiance "
          "in "
          "W/(m² sr); glTF: an emissiveFactor), and use that material on at least one face; or let in light "
          "from all around"),
      {{Setting::sky, "1"}});
}

}  // namespace luxel
