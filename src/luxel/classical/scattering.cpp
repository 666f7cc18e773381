// SPDX-License-Identifier: Apache-2.0
#include "luxel/classical/scattering.h"

#include "luxel/core/none.h"

namespace luxel {

ScatteringTable scattering_of(const PatchSet& patches, const GatherSides& sides) {
  const auto bands = patches.band_count();
  ScatteringTable table;
  table.reflectance.reserve(sides.size() * bands);
  for (const auto side : sides.side)
    for (std::size_t b = 0; b < bands; ++b) table.reflectance.push_back(patches.reflectance(side.patch(), b));
  if (!patches.has_diffusers()) return table;
  for (std::uint32_t s = 0; s < sides.size(); ++s) {
    const auto patch = sides.side[s].patch();
    const auto other = sides.receiver_of_side[sides.side[s].opposite().index()];
    const bool transmits = patches.material_of(patch).is_diffuser() && other != none;
    table.far.push_back(transmits ? other : s);
    for (std::size_t b = 0; b < bands; ++b)
      table.transmittance.push_back(transmits ? patches.diffuse_transmittance(patch, b) : 0.0f);
  }
  return table;
}

ScatteringTable twice(const Scattering& scattering) {
  ScatteringTable both{{scattering.reflectance.begin(), scattering.reflectance.end()},
                       {scattering.transmittance.begin(), scattering.transmittance.end()},
                       {scattering.far.begin(), scattering.far.end()}};
  both.reflectance.insert(both.reflectance.end(), scattering.reflectance.begin(),
                          scattering.reflectance.end());
  both.transmittance.insert(both.transmittance.end(), scattering.transmittance.begin(),
                            scattering.transmittance.end());
  const auto rows = static_cast<std::uint32_t>(scattering.far.size());
  for (const auto row : scattering.far) both.far.push_back(row + rows);
  return both;
}

}  // namespace luxel
