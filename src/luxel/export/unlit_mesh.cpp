// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/unlit_mesh.h"

#include <utility>

#include "luxel/core/utf8.h"
#include "luxel/export/y_up.h"

namespace luxel {

Json add_coloured_vertices(GltfWriter& file, std::span<const Vec3> positions,
                           std::span<const Rgba16> colours) {
  const auto position = file.add_positions(positions);
  return {{"POSITION", position}, {"COLOR_0", file.add_colours(colours)}};
}

Json unlit_material(const std::string& name, const Vec3& base_colour, bool two_sided) {
  Json surface = {{"metallicFactor", 0.0}, {"roughnessFactor", 0.9}};
  if (base_colour != Vec3(1.0f))
    surface["baseColorFactor"] = {base_colour.r, base_colour.g, base_colour.b, 1.0f};
  Json material = {{"name", valid_utf8(name)}, {"pbrMetallicRoughness", std::move(surface)}};
  if (two_sided) material["doubleSided"] = true;
  material["extensions"]["KHR_materials_unlit"] = Json::object();
  return material;
}

void add_root(GltfWriter& file, Json node, const Vec3& up, const Vec3d& origin) {
  turn_node_y_up(node, up, origin);
  const auto number = file.append("/nodes", node);
  file.put("/scene", file.append("/scenes", {{"nodes", Json::array({number})}}));
}

}  // namespace luxel
