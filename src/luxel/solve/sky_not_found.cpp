// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/sky_not_found.h"

#include <cmath>
#include <numeric>

namespace luxel {

std::vector<float> sky_not_found(const PatchSet& patches, const HitStore& hits,
                                 std::span<const std::uint32_t> units) {
  const auto bands = patches.band_count();
  std::vector<float> variance(hits.sides().size() * bands, 0.0f);
  if (!patches.has_sky()) return variance;
  const auto rays_per_slot = hits.rays_per_slot();
  for (std::size_t u = 0; u + 1 < units.size(); ++u) {
    const auto of_unit = rays_per_slot.subspan(units[u], units[u + 1] - units[u]);
    const auto rays = hits.replicates() * std::accumulate(of_unit.begin(), of_unit.end(), 0.0);
    if (rays == 0.0) continue;
    for (auto s = units[u]; s < units[u + 1]; ++s)
      for (std::size_t b = 0; b < bands; ++b)
        variance[s * bands + b] = static_cast<float>(0.5 * std::pow(patches.sky_radiosity(b) / rays, 2.0));
  }
  return variance;
}

}  // namespace luxel
