// SPDX-License-Identifier: Apache-2.0
#include "luxel/patch/uncut_faces.h"

namespace luxel {
namespace {

constexpr float flat = 1e-6f;  // 1 minus the cosine between normals

}  // namespace

std::vector<std::uint32_t> uncut_faces(const Scene& scene, const PatchSet& patches) {
  std::vector<std::uint32_t> patches_of(scene.triangles.size(), 0);
  for (const auto triangle : patches.triangle) ++patches_of[triangle];
  std::vector<std::uint32_t> face(patches.size());
  std::uint32_t count = 0;
  for (std::size_t p = 0; p < patches.size(); ++p) {
    // Patches are in the order of triangles, and these in the order of the file.
    const auto belongs_to = [&](std::size_t before) {
      const auto a = patches.triangle[before];
      const auto b = patches.triangle[p];
      return patches_of[a] == 1 && patches_of[b] == 1 && scene.triangle_line[a] != 0 &&
             scene.triangle_line[a] == scene.triangle_line[b] &&
             patches.material[before] == patches.material[p] &&
             glm::dot(patches.normal[before], patches.normal[p]) > 1.0f - flat;
    };
    face[p] = p > 0 && belongs_to(p - 1) ? face[p - 1] : count++;
  }
  return face;
}

}  // namespace luxel
