// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>

#include "scenes/shapes/mesh.h"

namespace luxel::scenes {

// Edges that do not have exactly one triangle on each side, running opposite ways.
inline int open_edges(const Mesh& mesh) {
  auto count = std::map<std::pair<std::uint32_t, std::uint32_t>, int>{};
  for (const auto& [corners, paint] : mesh.triangles) {
    for (auto k = 0u; k < 3; ++k) ++count[{corners[k], corners[(k + 1) % 3]}];
  }
  return static_cast<int>(std::count_if(count.begin(), count.end(), [&](const auto& edge) {
    const auto back = count.find({edge.first.second, edge.first.first});
    return edge.second != 1 || back == count.end() || back->second != 1;
  }));
}

// Gauss's theorem: positive where the faces look outwards. m³.
inline double enclosed_volume(const Mesh& mesh) {
  auto volume = 0.0;
  for (const auto& triangle : mesh.triangles) {
    volume += glm::dot(centroid(mesh, triangle), area_vector(mesh, triangle)) / 3.0;
  }
  return volume;
}

}  // namespace luxel::scenes
