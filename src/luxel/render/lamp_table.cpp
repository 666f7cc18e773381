// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/lamp_table.h"

#include <algorithm>
#include <numeric>

#include "luxel/core/warp.h"

namespace luxel {

LampTable::LampTable(const PatchSet& patches) {
  for (const auto& m : patches.materials)
    density_.push_back(std::accumulate(m.emittance.begin(), m.emittance.end(), 0.0));
  double power = 0.0;
  for (std::size_t p = 0; p < patches.size(); ++p) {
    if (!(density(patches, p) > 0.0)) continue;
    power += static_cast<double>(patches.area[p]) * density(patches, p);
    patch_.push_back(static_cast<std::uint32_t>(p));
    power_up_to_.push_back(power);
  }
  if (patch_.empty()) return;
  for (auto& p : power_up_to_) p /= power;
  for (auto& d : density_) d /= power;
}

SurfacePoint LampTable::sample(const PatchSet& patches, const std::array<float, 3>& u) const {
  const auto at = std::upper_bound(power_up_to_.begin(), power_up_to_.end(), static_cast<double>(u[0]));
  const auto lamp =
      std::min(static_cast<std::size_t>(at - power_up_to_.begin()), patch_.size() - 1);  // rounding
  return surface_point(patches, patch_[lamp], false, uniform_triangle(u[1], u[2]));
}

}  // namespace luxel
