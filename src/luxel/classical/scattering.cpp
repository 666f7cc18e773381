// SPDX-License-Identifier: Apache-2.0
#include "luxel/classical/scattering.h"

#include "luxel/core/none.h"

namespace luxel {

namespace {

constexpr std::size_t grain = 4096;  // receivers per chunk

}  // namespace

ScatteringTable scattering_of(const PatchSet& patches, const GatherSides& sides, const Context& context) {
  const auto bands = patches.band_count();
  const bool transmits = patches.has_diffusers();
  ScatteringTable table;
  table.reflectance.resize(sides.size() * bands);
  table.transmittance.assign(transmits ? sides.size() * bands : 0, 0.0f);
  table.far.resize(transmits ? sides.size() : 0);
  context.for_chunks(sides.size(), grain, [&](std::size_t begin, std::size_t end, int) {
    for (auto s = begin; s < end; ++s) {
      const auto patch = sides.side[s].patch();
      for (std::size_t b = 0; b < bands; ++b)
        table.reflectance[s * bands + b] = patches.reflectance(patch, b);
      if (!transmits) continue;
      const auto other = sides.receiver_of_side[sides.side[s].opposite().index()];
      const bool diffuses = patches.material_of(patch).is_diffuser() && other != none;
      table.far[s] = diffuses ? other : static_cast<std::uint32_t>(s);
      for (std::size_t b = 0; diffuses && b < bands; ++b)
        table.transmittance[s * bands + b] = patches.diffuse_transmittance(patch, b);
    }
  });
  return table;
}

ScatteringTable repeated_twice(const Scattering& scattering) {
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
