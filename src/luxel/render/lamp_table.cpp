// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/lamp_table.h"

#include <numeric>

#include "luxel/core/warp.h"

namespace luxel {

LampTable::LampTable(const PatchSet& patches) {
  for (const auto& m : patches.materials)
    density_.push_back(std::accumulate(m.emittance.begin(), m.emittance.end(), 0.0));
  for (std::size_t p = 0; p < patches.size(); ++p) {
    if (!(density(patches, p) > 0.0)) continue;
    patch_.push_back(static_cast<std::uint32_t>(p));
    by_power_.add(static_cast<double>(patches.area[p]) * density(patches, p));
  }
  if (patch_.empty()) return;
  const auto power = by_power_.total();
  by_power_.normalise();
  for (auto& d : density_) d /= power;
}

SurfacePoint LampTable::sample(const PatchSet& patches, const std::array<float, 3>& u) const {
  const auto lamp = by_power_.choose(static_cast<double>(u[0]));
  return surface_point(patches, patch_[lamp], false, uniform_triangle(u[1], u[2]));
}

}  // namespace luxel
