// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/export_coloured.h"

#include <utility>

#include "luxel/core/output_file.h"
#include "luxel/core/triangle.h"
#include "luxel/core/utf8.h"
#include "luxel/export/unlit_mesh.h"

namespace luxel {
namespace {

// Lighter where a triangle faces up, darker below, and slightly different to each side.
float shade(const Vec3& normal, const Vec3& up) {
  const auto level = glm::dot(normal, up);
  const auto aside = glm::dot(normal, glm::normalize(Vec3(0.6f, 0.35f, 0.7f)));
  return 0.62f + 0.18f * level + 0.2f * aside;
}

Json add_primitive(GltfWriter& file, const ColouredMesh& mesh, const Vec3& up) {
  std::vector<Vec3> positions;
  std::vector<Rgba16> shades;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (const auto& t : mesh.triangles) {
    const auto normal = triangle_normal(mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]);
    const auto first = static_cast<std::uint32_t>(positions.size());
    for (const auto v : t) {
      positions.push_back(mesh.positions[v]);
      shades.push_back(quantise(Vec3(shade(normal, up))));
    }
    triangles.push_back({first, first + 1, first + 2});
  }
  auto attributes = add_coloured_vertices(file, positions, shades);
  return {{"attributes", std::move(attributes)}, {"indices", file.add_indices(triangles, positions.size())}};
}

// Returns the node's index.
std::size_t add_mesh(GltfWriter& file, const ColouredMesh& mesh, const Vec3& up) {
  auto primitive = add_primitive(file, mesh, up);
  primitive["material"] = file.append("/materials", unlit_material(mesh.name, mesh.colour, true));
  const auto name = valid_utf8(mesh.name);
  const auto number =
      file.append("/meshes", {{"name", name}, {"primitives", Json::array({std::move(primitive)})}});
  return file.append("/nodes", {{"name", name}, {"mesh", number}});
}

}  // namespace

void export_coloured(const std::filesystem::path& path, const std::string& title,
                     std::span<const ColouredMesh> meshes, const Vec3& up, const Vec3d& origin) {
  GltfWriter file;
  file.put("/asset/generator", "Luxel");
  file.use_extension("KHR_materials_unlit");
  Json root = {{"name", valid_utf8(title)}};
  for (const auto& mesh : meshes)
    if (!mesh.triangles.empty()) root["children"].push_back(add_mesh(file, mesh, glm::normalize(up)));
  add_root(file, std::move(root), up, origin);
  write_file(path, file.bytes(path.string()));
}

}  // namespace luxel
