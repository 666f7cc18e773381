// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/page_mesh.h"

#include <limits>

#include "luxel/solution/back_is_lit.h"

namespace luxel {
namespace {

constexpr auto unnumbered = std::numeric_limits<std::uint32_t>::max();

// number: [smooth vertex]; its vertex of the material at hand, or unnumbered.
void add_triangle(PageMesh& mesh, const SmoothLight& light, std::size_t material, std::uint32_t patch,
                  std::vector<std::uint32_t>& number) {
  auto corners = light.corners[patch];
  for (auto& corner : corners) {
    auto& n = number[corner];
    if (n == unnumbered) {
      n = static_cast<std::uint32_t>(mesh.vertices.size());
      mesh.vertices.push_back({corner, material});
    }
    corner = n;
  }
  mesh.triangles.push_back(corners);
  mesh.patch.push_back(patch);
}

}  // namespace

PageMesh make_page_mesh(const PatchSet& patches, const Solution& solution, const SmoothLight& light) {
  std::vector<std::vector<std::uint32_t>> of_part(2 * patches.materials.size());
  for (std::uint32_t p = 0; p < patches.size(); ++p)
    of_part[2 * static_cast<std::size_t>(patches.material[p]) + (back_is_lit(solution, p) ? 1 : 0)].push_back(
        p);
  PageMesh mesh;
  std::vector<std::uint32_t> number(light.size(), unnumbered);
  for (std::size_t m = 0; m < patches.materials.size(); ++m) {
    const auto first_vertex = mesh.vertices.size();
    for (const bool back : {false, true}) {
      const auto& members = of_part[2 * m + (back ? 1 : 0)];
      if (!members.empty()) mesh.parts.push_back({m, back, mesh.triangles.size(), members.size()});
      for (const auto p : members) add_triangle(mesh, light, m, p, number);
    }
    for (auto v = first_vertex; v < mesh.vertices.size(); ++v) number[mesh.vertices[v].smooth] = unnumbered;
  }
  return mesh;
}

}  // namespace luxel
