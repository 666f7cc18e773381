// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
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
  // light fell on their backs, and they are not hidden; else there is nothing to be seen from behind
  bool back_is_lit = false;
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
  std::vector<std::uint8_t> back_is_lit;                // [triangle]: that of its part
  std::vector<PagePart> parts;  // by material, lit fronts first, of each lit backs last
};

// hidden_backs: see PageOptions.
PageMesh make_page_mesh(const PatchSet& patches, const Solution& solution, const SmoothLight& light,
                        const PageTextures& textures, std::span<const std::uint8_t> hidden_backs = {});

}  // namespace luxel
