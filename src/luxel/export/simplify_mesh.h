// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "luxel/image/tone.h"
#include "luxel/patch/patch_set.h"
#include "luxel/patch/side.h"
#include "luxel/solution/solution.h"
#include "luxel/surface/smooth_light.h"

namespace luxel {

struct SimplifyOptions {
  // Largest error of the displayed colour that a removed vertex may leave, in sRGB-encoded values, 1 for the
  // brightest; where the display is brighter than white, of the irradiance, relative.
  float max_error = 0.75f / 255.0f;
  // Patches with textures stay, for meshes that show textures by the means of patches.
  bool keeps_textured_patches = false;
  // Sides whose light is not shown, see hidden_sides(); empty: none. A hidden back becomes dark.
  FrontAndBack<std::uint8_t> hidden = {};
};

// A mesh that shows the same light as another, with fewer triangles.
struct SimplifiedMesh {
  PatchSet patches;   // as far as meshes need them: without the means of textures unless they are kept
  Solution solution;  // irradiance and radiosity alone, the means over the new patches
  SmoothLight light;
};

// Removes the vertices that the light does not need: those at which linear interpolation between the others
// displays the same colour, by half-edge collapses (Hoppe et al., Mesh Optimization, SIGGRAPH 1993). Patches
// merge only within one input triangle, so surfaces, edges, texture coordinates and borders of materials
// stay; neighbours stay joined, and lines at which the light jumps stay. Every removed vertex is compared
// with the triangle that covers it to the end, so errors there do not accumulate; the middles of removed
// edges are compared with the mesh before. Both sides of a patch count where both are lit.
//
// curve: the tone curve of the display. Cost: about 5 us per vertex of the patches, on one thread. The result
// depends on the input alone.
SimplifiedMesh simplify_mesh(const PatchSet& patches, const Solution& solution, const SmoothLight& light,
                             const ToneCurve& curve, const SimplifyOptions& options = {});

}  // namespace luxel
