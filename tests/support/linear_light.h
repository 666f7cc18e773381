// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/patch/patch_set.h"
#include "luxel/solution/solution.h"

namespace luxel::test {

// Light that was not solved, and that reconstruction has exactly: linear in space, of another kind on backs.
inline float linear_front(const Vec3& p) { return 5.0f + 0.5f * p.x - 0.25f * p.y + 0.75f * p.z; }
inline float linear_back(const Vec3& p) { return 2.0f - 0.125f * p.x + 0.25f * p.y + 0.125f * p.z; }

inline Solution linear_light(const PatchSet& patches) {
  Solution s;
  s.bands = patches.bands;
  for (std::size_t p = 0; p < patches.size(); ++p)
    for (std::size_t b = 0; b < patches.band_count(); ++b) {
      const auto& m = patches.material_of(p);
      const auto front = linear_front(patches.centroid(p));
      const auto back = m.two_sided ? linear_back(patches.centroid(p)) : 0.0f;
      s.irradiance.front.push_back(front);
      s.irradiance.back.push_back(back);
      s.radiosity.front.push_back(m.emittance[b] + m.reflectance[b] * front);
      s.radiosity.back.push_back(m.reflectance[b] * back);
    }
  return s;
}

}  // namespace luxel::test
