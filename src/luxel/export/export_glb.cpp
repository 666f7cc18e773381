// SPDX-License-Identifier: Apache-2.0
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "luxel/export/export_mesh.h"
#include "luxel/export/glb_model.h"
#include "luxel/export/lit_mesh.h"
#include "luxel/export/utf8.h"
#include "luxel/scene/luminous_efficacy.h"

namespace luxel {
namespace {

// The columns of one part as glTF wants them.
struct Columns {
  std::vector<Vec3> position;
  std::vector<Vec3> normal;
  std::vector<Rgba16> colour;
  std::vector<Vec3> irradiance;
};

Columns columns_of(const LitMesh& mesh, const LitPart& part, const ExportProfile& profile) {
  Columns columns;
  for (std::size_t i = 0; i < part.smooth.size(); ++i) {
    const auto v = mesh.vertex(part, i);
    columns.position.push_back(v.position);
    columns.normal.push_back(v.normal);
    columns.colour.push_back(quantise(profile.colours_are_srgb ? srgb_codes(v.colour) : v.colour));
    if (profile.keeps_irradiance) columns.irradiance.push_back(v.irradiance);
  }
  return columns;
}

tinygltf::Primitive add_primitive(tinygltf::Model& model, const LitMesh& mesh, const LitPart& part,
                                  const ExportProfile& profile) {
  const auto columns = columns_of(mesh, part, profile);
  tinygltf::Primitive primitive;
  primitive.mode = TINYGLTF_MODE_TRIANGLES;
  add_vertices(model, primitive, columns.position, columns.colour);
  primitive.attributes["NORMAL"] = add_array(model, columns.normal, vector_of_floats);
  if (profile.keeps_irradiance)
    primitive.attributes["_IRRADIANCE"] = add_array(model, columns.irradiance, vector_of_floats);
  primitive.indices = add_indices(model, part.triangles, part.smooth.size());
  return primitive;
}

void add_mesh(tinygltf::Model& model, const PatchSet& patches, const LitMesh& mesh,
              const ExportProfile& profile) {
  tinygltf::Mesh lit;
  lit.name = "lit surfaces";
  auto last_material = std::numeric_limits<std::size_t>::max();
  for (const auto& part : mesh.parts()) {
    if (part.material != last_material)
      model.materials.push_back(unlit_material(
          fmt::format("{}{}", patches.materials[part.material].name, profile.material_suffix)));
    last_material = part.material;
    lit.primitives.push_back(add_primitive(model, mesh, part, profile));
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

tinygltf::Value words(std::string_view text) { return tinygltf::Value(std::string(text)); }

// What the numbers at the vertices are.
tinygltf::Value light_of(const ToneCurve& curve, const TargetApplication program) {
  const auto profile = profile_of(program);
  tinygltf::Value::Object attributes = {
      {"COLOR_0", tinygltf::Value(tinygltf::Value::Object{
                      {"quantity", words("radiance after the tone curve")},
                      {"unit", words("1: the display's white")},
                      {"encoding", words(profile.colours_are_srgb ? "sRGB codes" : "linear sRGB")},
                      {"tone", words(name(curve.options.op))},
                      {"scale", tinygltf::Value(static_cast<double>(curve.scale))},
                  })}};
  if (profile.keeps_irradiance)
    attributes.emplace("_IRRADIANCE", tinygltf::Value(tinygltf::Value::Object{
                                          {"quantity", words("irradiance")},
                                          {"unit", words("W/m2 by linear sRGB")},
                                          {"radiance", words("reflectance * irradiance / pi")},
                                          {"lumens_per_watt", tinygltf::Value(luminous_efficacy)},
                                      }));
  return tinygltf::Value(tinygltf::Value::Object{{"made_for", words(name(program))},
                                                 {"as", words("vertex")},
                                                 {"attributes", tinygltf::Value(std::move(attributes))}});
}

tinygltf::Value provenance_of(const Solution& solution, tinygltf::Value light) {
  const auto& from = solution.provenance;
  return tinygltf::Value(tinygltf::Value::Object{
      {"light", std::move(light)},
      {"method", tinygltf::Value(valid_utf8(from.method))},
      {"rays", tinygltf::Value(static_cast<double>(from.rays))},
      {"seed", tinygltf::Value(fmt::format("{}", from.seed))},
      {"unshot_fraction", tinygltf::Value(solution.unshot_fraction)},
      {"seen_error", tinygltf::Value(solution.seen_error)},
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
  model.asset.extras = provenance_of(solution, light_of(mesh.curve(), options.program));
  if (!mesh.parts().empty()) {  // glTF knows no empty mesh
    model.extensionsUsed = {"KHR_materials_unlit"};
    model.buffers.emplace_back();
    add_mesh(model, patches, mesh, profile_of(options.program));
    add_root(model, lit_root(), up, patches.origin);
  }
  write_glb(path, model);
}

}  // namespace luxel
