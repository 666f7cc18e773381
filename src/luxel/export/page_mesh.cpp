// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/page_mesh.h"

#include <map>
#include <tuple>

#include "luxel/solution/back_is_lit.h"

namespace luxel {
namespace {

// Adds triangles to a mesh; corners that agree in all are one vertex.
class MeshMaker {
 public:
  MeshMaker(const PatchSet& patches, const SmoothLight& light, const PageTextures& textures, PageMesh& mesh)
      : closed_(patches, light), textures_(textures), mesh_(mesh) {}

  void start_material(std::size_t material) {
    material_ = material;
    numbers_.clear();
  }

  void add(std::uint32_t patch) {
    for (const auto& points : closed_.triangles(patch)) {
      std::array<std::uint32_t, 3> corners{};
      for (std::size_t k = 0; k < 3; ++k) corners[k] = vertex(patch, points[k]);
      mesh_.triangles.push_back(corners);
      mesh_.patch.push_back(patch);
    }
  }

 private:
  std::uint32_t vertex(std::uint32_t patch, const DrawnPoint& point) {
    const auto places = textures_.places(patch, point.weight);
    const auto key = std::tuple(point.vertex, point.smooth, point.fraction, places);
    const auto [found, is_new] = numbers_.try_emplace(key, static_cast<std::uint32_t>(mesh_.vertices.size()));
    if (is_new) mesh_.vertices.push_back({point, material_, places});
    return found->second;
  }

  ClosedPatches closed_;
  const PageTextures& textures_;
  PageMesh& mesh_;
  std::size_t material_ = 0;
  std::map<std::tuple<std::uint32_t, std::array<std::uint32_t, 2>, float, PagePlaces>, std::uint32_t>
      numbers_;
};

}  // namespace

PageMesh make_page_mesh(const PatchSet& patches, const Solution& solution, const SmoothLight& light,
                        const PageTextures& textures) {
  std::vector<std::vector<std::uint32_t>> of_part(2 * patches.materials.size());
  for (std::uint32_t p = 0; p < patches.size(); ++p)
    of_part[2 * static_cast<std::size_t>(patches.material[p]) + (back_is_lit(solution, p) ? 1 : 0)].push_back(
        p);
  PageMesh mesh;
  MeshMaker maker(patches, light, textures, mesh);
  for (std::size_t m = 0; m < patches.materials.size(); ++m) {
    maker.start_material(m);
    for (const bool back : {false, true}) {
      const auto& members = of_part[2 * m + (back ? 1 : 0)];
      const auto first = mesh.triangles.size();
      for (const auto p : members) maker.add(p);
      if (const auto count = mesh.triangles.size() - first; count > 0)
        mesh.parts.push_back({m, back, first, count});
    }
  }
  return mesh;
}

}  // namespace luxel
