// SPDX-License-Identifier: Apache-2.0
#include "luxel/lamps/side_power.h"

#include <algorithm>
#include <cassert>
#include <numbers>

#include "luxel/patch/side.h"
#include "luxel/trace/patch_emitter.h"

namespace luxel {

SidePower lamp_power(const PatchSet& patches) {
  std::vector<std::uint8_t> shines;  // [material]
  for (const auto& material : patches.materials) shines.push_back(material.is_lamp() ? 1 : 0);
  SidePower power;
  for (std::size_t p = 0; p < patches.size(); ++p) {
    if (!shines[static_cast<std::size_t>(patches.material[p])]) continue;
    power.side.push_back(SideId(p, false));
    for (std::size_t b = 0; b < patches.band_count(); ++b)
      power.watts.push_back(static_cast<double>(patches.area[p]) *
                            static_cast<double>(patches.emittance(p, b)));
  }
  return power;
}

void add_sky_power(const PatchSet& patches, const SkyBox& box, SidePower& power) {
  const auto sky = patches.mean_sky();
  for (std::size_t face = 0; face < SkyBox::faces; ++face) {
    power.side.push_back(SideId::at(side_count(patches.size()) + face));
    for (std::size_t b = 0; b < patches.band_count(); ++b)
      power.watts.push_back(box.area(face) * std::numbers::pi * static_cast<double>(sky[b]));
  }
}

EntryRange entries_between(std::span<const SideId> side, SideId begin, SideId end) {
  assert(begin <= end);
  const auto first = std::lower_bound(side.begin(), side.end(), begin);
  const auto last = std::lower_bound(first, side.end(), end);
  return {static_cast<std::size_t>(first - side.begin()), static_cast<std::size_t>(last - side.begin())};
}

}  // namespace luxel
