// SPDX-License-Identifier: Apache-2.0
#include <limits>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "luxel/export/export_mesh.h"
#include "luxel/export/glb_model.h"
#include "luxel/export/lit_mesh.h"
#include "luxel/export/utf8.h"

namespace luxel {
namespace {

// The columns of one part as glTF wants them.
struct Columns {
  std::vector<Vec3> position;
  std::vector<Vec3> normal;
  std::vector<Rgba16> colour;
};

Columns columns_of(const LitMesh& mesh, const LitPart& part) {
  Columns columns;
  for (std::size_t i = 0; i < part.smooth.size(); ++i) {
    const auto v = mesh.vertex(part, i);
    columns.position.push_back(v.position);
    columns.normal.push_back(v.normal);
    columns.colour.push_back(quantise(v.colour));
  }
  return columns;
}

tinygltf::Primitive add_primitive(tinygltf::Model& model, const LitMesh& mesh, const LitPart& part) {
  const auto columns = columns_of(mesh, part);
  tinygltf::Primitive primitive;
  primitive.mode = TINYGLTF_MODE_TRIANGLES;
  add_vertices(model, primitive, columns.position, columns.colour);
  primitive.attributes["NORMAL"] = add_array(model, columns.normal, vector_of_floats);
  primitive.indices = add_indices(model, part.triangles, part.smooth.size());
  return primitive;
}

void add_mesh(tinygltf::Model& model, const PatchSet& patches, const LitMesh& mesh) {
  tinygltf::Mesh lit;
  lit.name = "lit surfaces";
  auto last_material = std::numeric_limits<std::size_t>::max();
  for (const auto& part : mesh.parts()) {
    if (part.material != last_material)
      model.materials.push_back(unlit_material(patches.materials[part.material].name));
    last_material = part.material;
    lit.primitives.push_back(add_primitive(model, mesh, part));
    lit.primitives.back().material = static_cast<int>(model.materials.size() - 1);
  }
  model.meshes.push_back(std::move(lit));
}

tinygltf::Node lit_root() {
  tinygltf::Node root;
  root.name = "scene";
  root.mesh = 0;
  return root;
}

tinygltf::Value provenance_of(const Solution& solution) {
  const auto& from = solution.provenance;
  return tinygltf::Value(tinygltf::Value::Object{
      {"method", tinygltf::Value(valid_utf8(from.method))},
      {"rays", tinygltf::Value(static_cast<double>(from.rays))},
      {"seed", tinygltf::Value(fmt::format("{}", from.seed))},
      {"unshot_share", tinygltf::Value(solution.unshot_share)},
      {"predicted_error", tinygltf::Value(solution.predicted_error)},
      {"scene_fingerprint", tinygltf::Value(fmt::format("{:016x}", from.scene_fingerprint))},
  });
}

}  // namespace

void export_glb(const std::filesystem::path& path, const PatchSet& patches, const Solution& solution,
                const SmoothLight& light, const Vec3& up, const ExportOptions& options) {
  const LitMesh mesh(patches, solution, light, options.tone);
  tinygltf::Model model;
  model.asset.version = "2.0";
  model.asset.generator = valid_utf8("Luxel " + solution.provenance.program_version);
  model.asset.extras = provenance_of(solution);
  if (!mesh.parts().empty()) {  // glTF knows no empty mesh
    model.extensionsUsed = {"KHR_materials_unlit"};
    model.buffers.emplace_back();
    add_mesh(model, patches, mesh);
    add_root(model, lit_root(), up, patches.origin);
  }
  write_glb(path, model);
}

}  // namespace luxel
