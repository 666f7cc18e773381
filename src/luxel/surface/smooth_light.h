// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "luxel/patch/patch_set.h"
#include "luxel/solution/solution.h"

namespace luxel {

struct SmoothOptions {
  float crease_angle = 30.0f;  // degrees; neighbours that meet at a sharper angle are different surfaces
};

// Light that runs smoothly over each surface: patch values averaged to the vertices, area-weighted over the
// neighbours of the same smooth surface, so that a corner between walls does not smear. Irradiance, not
// radiosity, is averaged: surface colour and emission are put on afterwards, per patch, and stay sharp at
// material borders. One smooth vertex for each vertex and each smooth surface that meets there.
struct SmoothLight {
  std::vector<std::uint32_t> vertex;                     // [smooth vertex]: index into PatchSet::vertices
  std::vector<Vec3> normal;                              // [smooth vertex]: unit, front side, area-weighted
  std::vector<float> irradiance_front, irradiance_back;  // [smooth vertex][band], W/m²
  std::vector<std::array<std::uint32_t, 3>> corners;     // [patch]: its three smooth vertices

  std::size_t size() const { return vertex.size(); }
};

// Cost: linear in the number of patches, one pass of sorting. Deterministic.
SmoothLight make_smooth_light(const PatchSet& patches, const Solution& solution,
                              const SmoothOptions& options = {});

// Radiance (W/(m² sr)) that leaves a side of a patch where its irradiance is the given one: (E + rho H) / pi.
// irradiance: [band]; result: [band], into out.
void radiance_of(const BandMaterial& material, bool back, const float* irradiance, float* out);

// The three bands of plain colour as linear sRGB. Throws MismatchError where bands are not red, green, blue.
void check_rgb(const std::vector<std::string>& bands);

}  // namespace luxel
