// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/sky_colours.h"

#include <span>

namespace luxel {

SkyColours::SkyColours(const PatchSet& patches, const BandColours& colours) : patches_(patches.sky_patches) {
  const auto bands = patches.band_count();
  for (std::size_t at = 0; at < patches.sky.size(); at += bands)
    radiance_.push_back(colours.rgb(std::span(patches.sky).subspan(at, bands)));
}

Vec3d SkyColours::at(const Vec3d& direction) const {
  if (radiance_.empty()) return Vec3d(0.0);
  if (patches_.is_one()) return radiance_[0];
  Vec3d sum(0.0);
  for (const auto& [patch, weight] : patches_.around(direction)) sum += weight * radiance_[patch];
  return sum;
}

}  // namespace luxel
