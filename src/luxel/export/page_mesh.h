// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "luxel/export/closed_patches.h"
#include "luxel/export/page_textures.h"
#include "luxel/patch/patch_set.h"
#include "luxel/solution/solution.h"
#include "luxel/surface/smooth_light.h"

namespace luxel {

// Patches of one material that are drawn together.
struct PagePart {
  std::size_t material = 0;
  bool front_is_hidden = false;  // next to no light fell on their fronts, nor do they emit
  bool back_is_lit = false;      // light fell on their backs; else there is nothing to be seen from behind
  std::size_t first = 0, count = 0;  // triangles
};

// The mesh that a page draws: the patches without T-junctions. A triangle has both sides; each material has
// its own vertices, which hold the light of that material.
struct PageMesh {
  struct Vertex {
    DrawnPoint point;
    std::size_t material;
    PagePlaces places;  // on the material's textures
  };
  std::vector<Vertex> vertices;                         // in the order in which triangles use them
  std::vector<std::array<std::uint32_t, 3>> triangles;  // indices into vertices
  std::vector<std::uint32_t> patch;                     // [triangle]
  std::vector<PagePart> parts;  // by material, lit fronts first, of each lit backs last
};

PageMesh make_page_mesh(const PatchSet& patches, const Solution& solution, const SmoothLight& light,
                        const PageTextures& textures);

}  // namespace luxel
