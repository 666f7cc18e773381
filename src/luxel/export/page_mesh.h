// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "luxel/patch/patch_set.h"
#include "luxel/solution/solution.h"
#include "luxel/surface/smooth_light.h"

namespace luxel {

// Patches of one material that are drawn together.
struct PagePart {
  std::size_t material = 0;
  bool back_is_lit = false;  // light fell on their backs; else there is nothing to be seen from behind
  std::size_t first = 0, count = 0;  // triangles
};

// The mesh that a page draws. A triangle is a patch and has both sides; vertices are not shared by materials,
// so that each may hold the light of its own material.
struct PageMesh {
  struct Vertex {
    std::uint32_t smooth;  // index into SmoothLight
    std::size_t material;
  };
  std::vector<Vertex> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;  // indices into vertices
  std::vector<std::uint32_t> patch;                     // [triangle]
  std::vector<PagePart> parts;                          // by material, lit backs last
};

PageMesh make_page_mesh(const PatchSet& patches, const Solution& solution, const SmoothLight& light);

}  // namespace luxel
