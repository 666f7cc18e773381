// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <numeric>
#include <vector>

#include "luxel/patch/patch_set.h"
#include "luxel/trace/point_sight.h"

namespace luxel {

// The numbers that choosing one of a scene's punctual lights and luminaires takes, made once for all points.
struct PunctualLights {
  explicit PunctualLights(const PatchSet& patches) {
    constexpr std::size_t few = 4;
    for (const auto& lamp : patches.point_lights) {
      const auto index = static_cast<std::uint32_t>(weights.size());
      (lamp.light.kind == PointLightKind::directional ? suns : chosen).push_back(index);
      weights.push_back(std::accumulate(lamp.intensity.begin(), lamp.intensity.end(), 0.0));
      if (has_opening(lamp.light)) with_opening.push_back(index);
      if (is_extended(lamp.light)) has_extended = true;
    }
    if (suns.size() <= few) return;
    chosen.insert(chosen.end(), suns.begin(), suns.end());
    suns.clear();
  }

  std::vector<double> weights;  // [light]: intensity summed over bands, W/sr
  // Indices into PatchSet::point_lights. Suns are not chosen: each has rays of its own, since it outshines
  // all else and seldom reaches a room.
  std::vector<std::uint32_t> suns, chosen;
  std::vector<std::uint32_t> with_opening;  // those of luminaires whose opening has an extent
  bool has_extended = false;                // whether samples need a point of an opening or a disc
};

}  // namespace luxel
