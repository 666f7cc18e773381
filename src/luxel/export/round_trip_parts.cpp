// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/round_trip_parts.h"

#include <utility>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/import/gltf_array.h"

namespace luxel {
namespace {

Vec3d placed(const GltfArray& positions, std::uint32_t vertex, const glm::dmat4& world) {
  const auto p = positions.at(vertex);
  return Vec3d(world * glm::dvec4(p[0], p[1], p[2], 1.0));
}

[[noreturn]] void refuse(const Scene& scene) {
  throw MismatchError(fmt::format(
      "{}: the scene has other triangles than the file: solve the file as it is now", scene.source));
}

// A flipped triangle has its second and third corner exchanged.
void match_corners(RoundTripPart& part, const GltfArray& positions, const Scene& scene, double scale) {
  for (std::size_t t = 0; t < part.corners.size(); ++t) {
    auto& corners = part.corners[t];
    if (part.mirrored) std::swap(corners[1], corners[2]);
    const auto& of_scene = scene.triangles[part.triangles[t]];
    const auto at = scale * placed(positions, corners[1], part.drawn.placed.world) - scene.origin;
    const auto off = [&](std::size_t i) { return glm::length(Vec3d(scene.positions[of_scene[i]]) - at); };
    if (off(1) <= off(2)) continue;
    std::swap(corners[1], corners[2]);
    part.as_read = false;
  }
}

}  // namespace

bool is_opaque(const Scene& scene, const RoundTripPart& part) {
  if (part.triangles.empty()) return false;
  return scene.materials[static_cast<std::size_t>(scene.triangle_material[part.triangles.front()])].opaque;
}

std::vector<RoundTripPart> round_trip_parts(GltfFile& file, const Scene& scene, double metres_per_unit,
                                            const std::vector<std::uint32_t>& order) {
  std::vector<RoundTripPart> parts;
  std::size_t triangles = 0;
  for (auto& drawn : drawn_parts(file, placed_nodes(file)).parts) {
    const GltfArray positions(file, drawn.primitive["attributes"]["POSITION"], 3, 3);
    auto corners = triangle_corners(file, drawn.primitive, positions.size());
    const auto begin = triangles;
    triangles += corners.size();
    if (triangles > scene.triangles.size()) refuse(scene);
    const bool mirrored = mirrors(drawn.placed.world);
    RoundTripPart part{std::move(drawn), positions.size(), {}, std::move(corners), mirrored};
    for (auto t = begin; t < triangles; ++t)
      part.triangles.push_back(order.empty() ? static_cast<std::uint32_t>(t) : order[t]);
    match_corners(part, positions, scene, metres_per_unit);
    parts.push_back(std::move(part));
  }
  // Triangles added to a glTF scene are not in its file; the glTF of any other scene contains all triangles.
  if (triangles != scene.triangles.size() && triangles + scene.added_triangles != scene.triangles.size())
    refuse(scene);
  return parts;
}

}  // namespace luxel
