// SPDX-License-Identifier: Apache-2.0
#include "luxel/patch/check_light.h"

#include <fmt/format.h>

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

void check_even_sky(const PatchSet& patches) {
  if (patches.has_even_sky()) return;
  throw with_hints(
      InputError("this method takes a sky that is the same all over, and this one differs by direction: the "
                 "methods sampled and shooting solve it, and luxel reference"),
      {{Setting::method, "sampled"}});
}

void check_no_panes(const PatchSet& patches) {
  if (patches.panes.empty()) return;
  const auto& glass = patches.materials[static_cast<std::size_t>(patches.panes.front().material)].name;
  throw with_hints(InputError(fmt::format(
                       "this method does not know glass that absorbs light, as '{}' does; solve it by the "
                       "sampled method or by luxel reference",
                       glass)),
                   {{Setting::method, "sampled"}});
}

}  // namespace luxel
