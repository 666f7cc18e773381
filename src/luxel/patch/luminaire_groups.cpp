// SPDX-License-Identifier: Apache-2.0
#include "luxel/patch/luminaire_groups.h"

#include <algorithm>
#include <vector>

#include "luxel/scene/band_colours.h"

namespace luxel {
namespace {

bool is_luminaire(const BandPointLight& lamp) { return lamp.light.kind == PointLightKind::luminaire; }

}  // namespace

bool has_luminaires(const PatchSet& patches) {
  return std::any_of(patches.point_lights.begin(), patches.point_lights.end(), is_luminaire);
}

double luminaire_lumens(const BandPointLight& lamp, const PatchSet& patches) {
  const auto& intensity = lamp.light.photometry->intensity;
  if (!patches.has_colours() || !(intensity.maximum() > 0.0)) return 0.0;
  return patches.colours().lumens(lamp.intensity) * intensity.linear_flux() / intensity.maximum();
}

double relative_lumens(const PatchSet& patches, std::size_t group, std::span<const float> weight) {
  double own = 0.0, weighted = 0.0;
  for (const auto& lamp : patches.point_lights) {
    if (!is_luminaire(lamp) || lamp.light_group != group) continue;
    own += luminaire_lumens(lamp, patches);
    auto coloured = lamp;
    for (std::size_t b = 0; b < coloured.intensity.size(); ++b) coloured.intensity[b] *= weight[b];
    weighted += luminaire_lumens(coloured, patches);
  }
  return own > 0.0 ? weighted / own : 1.0;
}

}  // namespace luxel
