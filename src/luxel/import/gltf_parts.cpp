// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/gltf_parts.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "luxel/import/gltf_areas.h"
#include "luxel/import/gltf_array.h"

namespace luxel {
namespace {

enum Mode : std::size_t { triangles = 4, strip = 5, fan = 6 };

std::size_t mode_of(const JsonValue& primitive) {
  const auto mode = primitive["mode"].whole(triangles);
  if (mode > fan) primitive["mode"].refuse(fmt::format("expected a mode from 0 to 6, found {}", mode));
  return mode;
}

bool draws_triangles(const JsonValue& primitive) {
  return mode_of(primitive) >= triangles && primitive["attributes"]["POSITION"];
}

// Returns the positions of triangle t in drawing order, counter-clockwise.
std::array<std::size_t, 3> places(std::size_t mode, std::size_t t) {
  if (mode == strip) return {t, t + 1 + t % 2, t + 2 - t % 2};
  if (mode == fan) return {t + 1, t + 2, 0};
  return {3 * t, 3 * t + 1, 3 * t + 2};
}

std::string object_name(const PlacedNode& placed, const JsonValue& mesh) {
  auto name = placed.node["name"].text(mesh["name"].text(""));
  return name.empty() ? fmt::format("node {}", placed.number) : name;
}

// The body that Luxel's exports have for the opening of a luminaire, which is no surface of the scene.
bool is_opening(const JsonValue& mesh) {
  const auto extras = mesh["extras"];
  return extras.is_object() && extras["luxel_opening"];
}

}  // namespace

const std::vector<std::string_view>& known_extensions() {
  static const std::vector<std::string_view> known = {"EXT_lights_ies",
                                                      "KHR_lights_punctual",
                                                      "KHR_materials_emissive_strength",
                                                      "KHR_materials_unlit",
                                                      "KHR_materials_pbrSpecularGlossiness",
                                                      "KHR_texture_transform",
                                                      "KHR_mesh_quantization",
                                                      "KHR_materials_anisotropy",
                                                      "KHR_materials_clearcoat",
                                                      "KHR_materials_dispersion",
                                                      "KHR_materials_ior",
                                                      "KHR_materials_iridescence",
                                                      "KHR_materials_sheen",
                                                      "KHR_materials_specular",
                                                      "KHR_materials_transmission",
                                                      "KHR_materials_diffuse_transmission",
                                                      "KHR_materials_variants",
                                                      "KHR_materials_volume",
                                                      "KHR_xmp_json_ld",
                                                      "KHR_draco_mesh_compression",
                                                      "EXT_meshopt_compression",
                                                      "EXT_texture_webp",
                                                      "KHR_texture_basisu"};
  return known;
}

GltfParts drawn_parts(const GltfFile& file, const std::vector<PlacedNode>& nodes) {
  GltfParts found;
  for (const auto& placed : nodes) {
    if (!placed.node["mesh"] || is_calculation_area(placed.node)) continue;
    const auto mesh = file.object(placed.node["mesh"], "meshes");
    if (is_opening(mesh)) continue;
    const auto primitives = mesh["primitives"];
    for (std::size_t i = 0; i < primitives.size(); ++i) {
      if (draws_triangles(primitives[i]))
        found.parts.push_back({placed, primitives[i], i, object_name(placed, mesh)});
      else
        ++found.without_triangles;
      if (primitives[i]["targets"].size() > 0) ++found.morphed;
    }
    if (placed.node["skin"]) ++found.skinned;
  }
  return found;
}

std::vector<std::array<std::uint32_t, 3>> triangle_corners(GltfFile& file, const JsonValue& primitive,
                                                           std::size_t vertices) {
  std::optional<GltfArray> indices;
  if (const auto index = primitive["indices"]) {
    indices.emplace(file, index, 1, 1);
    if (!indices->is_unsigned()) index.refuse("expected whole numbers without sign (5121, 5123 or 5125)");
  }
  const auto count = indices ? indices->size() : vertices;
  const auto mode = mode_of(primitive);
  if (mode == triangles && count % 3 != 0)
    primitive.refuse(fmt::format("expected three corners a triangle, found {} corners", count));
  const auto vertex = [&](std::size_t place) {
    if (!indices) return static_cast<std::uint32_t>(place);
    const auto index = indices->index_at(place);
    if (index >= vertices)
      primitive["indices"].refuse(fmt::format(
          "index {} names vertex {}, but there are only {} (numbered from 0)", place, index, vertices));
    return index;
  };
  std::vector<std::array<std::uint32_t, 3>> corners(mode == triangles ? count / 3
                                                                      : std::max<std::size_t>(count, 2) - 2);
  for (std::size_t t = 0; t < corners.size(); ++t) {
    const auto [a, b, c] = places(mode, t);
    corners[t] = {vertex(a), vertex(b), vertex(c)};
  }
  return corners;
}

bool mirrors(const glm::dmat4& world) { return glm::determinant(glm::dmat3(world)) < 0.0; }

}  // namespace luxel
