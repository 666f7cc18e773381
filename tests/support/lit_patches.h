// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "luxel/core/triangle.h"
#include "luxel/patch/patch_set.h"
#include "luxel/solution/solution.h"

namespace luxel::test {

// The same reflectance and emittance (W/m²) in red, green and blue.
inline BandMaterial plain_material(std::string name, float reflectance, bool two_sided = true,
                                   float emittance = 0.0f) {
  return {std::move(name), two_sided, std::vector<float>(3, reflectance), std::vector<float>(3, emittance)};
}

// Patches and their light written down by hand: every irradiance is the same in all three bands, and may be
// set by hand afterwards.
struct LitPatches {
  PatchSet patches;
  Solution solution;

  explicit LitPatches(std::vector<BandMaterial> materials = {plain_material("grey", 0.5f)}) {
    patches.bands = solution.bands = {"red", "green", "blue"};
    patches.materials = std::move(materials);
  }

  std::uint32_t vertex(const Vec3& position) {
    patches.vertices.push_back(position);
    return static_cast<std::uint32_t>(patches.vertices.size() - 1);
  }

  // Returns the patch's index.
  std::size_t patch(const std::array<std::uint32_t, 3>& corners, float front, float back = 0.0f,
                    std::uint32_t material = 0) {
    const auto &a = patches.vertices[corners[0]], &b = patches.vertices[corners[1]],
               &c = patches.vertices[corners[2]];
    patches.corners.push_back(corners);
    patches.normal.push_back(triangle_normal(a, b, c));
    patches.area.push_back(static_cast<float>(triangle_area(a, b, c)));
    patches.material.push_back(MaterialId(material));
    patches.triangle.push_back(static_cast<std::uint32_t>(patches.size() - 1));
    const auto& m = patches.materials[material];
    for (std::size_t band = 0; band < patches.band_count(); ++band) {
      solution.irradiance.front.push_back(front);
      solution.irradiance.back.push_back(back);
      solution.radiosity.front.push_back(m.emittance[band] + m.reflectance[band] * front);
      solution.radiosity.back.push_back(m.reflectance[band] * back);
    }
    return patches.size() - 1;
  }
};

}  // namespace luxel::test
