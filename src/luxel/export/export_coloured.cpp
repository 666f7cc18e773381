// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/export_coloured.h"

#include <utility>

#include "luxel/core/triangle.h"
#include "luxel/export/glb_model.h"
#include "luxel/export/utf8.h"

namespace luxel {
namespace {

// Lighter where a triangle faces up, darker below, and a little different to each side.
float shade(const Vec3& normal, const Vec3& up) {
  const auto level = glm::dot(normal, up);
  const auto aside = glm::dot(normal, glm::normalize(Vec3(0.6f, 0.35f, 0.7f)));
  return 0.62f + 0.18f * level + 0.2f * aside;
}

tinygltf::Primitive add_primitive(tinygltf::Model& model, const ColouredMesh& mesh, const Vec3& up) {
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
  tinygltf::Primitive primitive;
  primitive.mode = TINYGLTF_MODE_TRIANGLES;
  add_vertices(model, primitive, positions, shades);
  primitive.indices = add_indices(model, triangles, positions.size());
  return primitive;
}

void add_mesh(tinygltf::Model& model, const ColouredMesh& mesh, const Vec3& up) {
  auto material = unlit_material(mesh.name);
  material.doubleSided = true;
  material.pbrMetallicRoughness.baseColorFactor = {mesh.colour.r, mesh.colour.g, mesh.colour.b, 1.0};
  tinygltf::Mesh entry;
  entry.name = valid_utf8(mesh.name);
  entry.primitives.push_back(add_primitive(model, mesh, up));
  entry.primitives.back().material = static_cast<int>(model.materials.size());
  tinygltf::Node node;
  node.name = entry.name;
  node.mesh = static_cast<int>(model.meshes.size());
  model.materials.push_back(std::move(material));
  model.meshes.push_back(std::move(entry));
  model.nodes.push_back(std::move(node));
}

}  // namespace

void export_coloured(const std::filesystem::path& path, const std::string& title,
                     std::span<const ColouredMesh> meshes, const Vec3& up, const Vec3d& origin) {
  tinygltf::Model model;
  model.asset.version = "2.0";
  model.asset.generator = "Luxel";
  model.extensionsUsed = {"KHR_materials_unlit"};
  model.buffers.emplace_back();
  for (const auto& mesh : meshes)
    if (!mesh.triangles.empty()) add_mesh(model, mesh, glm::normalize(up));
  tinygltf::Node root;
  root.name = valid_utf8(title);
  for (int i = 0; i < static_cast<int>(model.nodes.size()); ++i) root.children.push_back(i);
  add_root(model, std::move(root), up, origin);
  write_glb(path, model);
}

}  // namespace luxel
