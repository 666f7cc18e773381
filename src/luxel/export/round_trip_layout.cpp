// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/round_trip_layout.h"

#include <map>

#include <fmt/format.h>

#include "luxel/export/round_trip_parts.h"
#include "luxel/import/gltf_array.h"
#include "luxel/import/is_gltf.h"

namespace luxel {
namespace {

constexpr int judged_at = 512;   // texels of a page
constexpr float beyond = 1e-4f;  // of a page: rounding

bool on_page(const Vec2& uv) {
  return uv.x >= -beyond && uv.y >= -beyond && uv.x <= 1.0f + beyond && uv.y <= 1.0f + beyond;
}

}  // namespace

std::optional<GivenLayout> round_trip_layout(const Scene& scene, const PatchSet& patches,
                                             double metres_per_unit, std::string& why) {
  why.clear();
  if (!is_gltf(scene.source)) return std::nullopt;
  GltfFile file(scene.source, known_extensions(), scene.allows_outside);
  GivenLayout given;
  given.uvs.resize(scene.triangles.size());
  given.page.resize(scene.triangles.size());
  std::map<std::size_t, std::uint32_t> page_of;  // [node]
  std::vector<std::uint32_t> pages(scene.triangles.size());
  std::size_t with = 0;
  std::string without;
  for (const auto& part : round_trip_parts(file, scene, metres_per_unit, {})) {
    if (!is_opaque(scene, part)) continue;
    const auto place = part.drawn.primitive["attributes"][lightmap_coordinates];
    if (!place) {
      without = part.drawn.object;
      continue;
    }
    ++with;
    const auto page =
        page_of.try_emplace(part.drawn.placed.number, static_cast<std::uint32_t>(page_of.size()))
            .first->second;
    const GltfArray array(file, place, 2, 2);
    const auto of_file = part.vertices_of_file();
    if (array.size() < of_file)
      place.refuse(fmt::format("expected {} elements, found {}", of_file, array.size()));
    std::vector<Vec2> uvs;
    for (std::uint32_t v = 0; v < of_file; ++v) uvs.emplace_back(array.at(v)[0], array.at(v)[1]);
    for (const auto& [a, b] : part.halved) uvs.push_back(0.5f * (uvs[a] + uvs[b]));
    for (std::size_t i = 0; i < part.triangles.size(); ++i) {
      const auto t = part.triangles[i];
      pages[t] = page;
      for (std::size_t k = 0; k < 3; ++k) {
        given.uvs[t][k] = uvs[part.corners[i][k]];
        if (!on_page(given.uvs[t][k]))
          why = fmt::format("those of '{}' go beyond the page", part.drawn.object);
      }
    }
  }
  if (with == 0) return std::nullopt;
  if (!without.empty()) why = fmt::format("'{}' has none", without);
  if (!why.empty()) return std::nullopt;
  if (!overlaps(scene, patches, given, judged_at)) return given;
  given.page = pages;
  given.pages = static_cast<std::uint32_t>(page_of.size());
  if (!overlaps(scene, patches, given, judged_at)) return given;
  why = "surfaces of one node lie over each other";
  return std::nullopt;
}

}  // namespace luxel
