// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/page_mesh.h"

#include <array>
#include <map>
#include <tuple>

#include "luxel/solution/back_is_lit.h"
#include "luxel/surface/hidden_light.h"

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
                        const PageTextures& textures, std::span<const std::uint8_t> hidden_backs) {
  const auto hidden = hidden_irradiance(patches, solution);
  const auto front_is_hidden = [&](std::uint32_t p) {
    double sum = 0.0;
    for (std::size_t b = 0; b < patches.band_count(); ++b)
      sum += static_cast<double>(solution.irradiance.front[p * patches.band_count() + b]) +
             static_cast<double>(patches.emittance(p, b));
    return sum <= hidden;
  };
  const auto shows_back = [&](std::uint32_t p) {
    return back_is_lit(solution, p) && (hidden_backs.empty() || hidden_backs[p] == 0);
  };
  // [material][front is hidden, back is lit]
  std::vector<std::array<std::vector<std::uint32_t>, 4>> of_part(patches.materials.size());
  for (std::uint32_t p = 0; p < patches.size(); ++p)
    of_part[static_cast<std::size_t>(patches.material[p])]
           [(front_is_hidden(p) ? 2u : 0u) + (shows_back(p) ? 1u : 0u)]
               .push_back(p);
  PageMesh mesh;
  MeshMaker maker(patches, light, textures, mesh);
  for (std::size_t m = 0; m < patches.materials.size(); ++m) {
    maker.start_material(m);
    for (std::size_t part = 0; part < of_part[m].size(); ++part) {
      const auto& members = of_part[m][part];
      const auto first = mesh.triangles.size();
      for (const auto p : members) maker.add(p);
      if (const auto count = mesh.triangles.size() - first; count > 0)
        mesh.parts.push_back({m, part >= 2, part % 2 != 0, first, count});
      mesh.back_is_lit.resize(mesh.triangles.size(), part % 2 != 0 ? 1 : 0);
    }
  }
  return mesh;
}

}  // namespace luxel
