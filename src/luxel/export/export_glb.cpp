// SPDX-License-Identifier: Apache-2.0
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "luxel/core/utf8.h"
#include "luxel/export/back_gap.h"
#include "luxel/export/export_mesh.h"
#include "luxel/export/light_metadata.h"
#include "luxel/export/lit_mesh.h"
#include "luxel/export/opening_bodies.h"
#include "luxel/export/unlit_mesh.h"
#include "luxel/export/write_glb.h"

namespace luxel {
namespace {

// The columns of one part in glTF's layout.
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

Json add_primitive(GltfWriter& file, const LitMesh& mesh, const LitPart& part, const ExportProfile& profile,
                   float gap) {
  auto columns = columns_of(mesh, part, profile);
  if (part.back && gap > 0.0f) move_outwards(columns.position, part.triangles, gap);
  auto attributes = add_coloured_vertices(file, columns.position, columns.colour);
  attributes["NORMAL"] = file.add_vectors(std::span(columns.normal));
  if (profile.keeps_irradiance) attributes["_IRRADIANCE"] = file.add_vectors(std::span(columns.irradiance));
  return {{"attributes", std::move(attributes)},
          {"indices", file.add_indices(part.triangles, part.smooth.size())}};
}

void add_mesh(GltfWriter& file, const PatchSet& patches, const LitMesh& mesh, TargetApplication program) {
  const auto profile = profile_of(program);
  const auto gap = back_gap(patches, program);
  Json primitives = Json::array();
  auto last_material = std::numeric_limits<std::size_t>::max();
  std::size_t number = 0;  // of the file's material
  for (const auto& part : mesh.parts()) {
    if (part.material != last_material)
      number =
          file.append("/materials", unlit_material(fmt::format("{}{}", patches.materials[part.material].name,
                                                               profile.material_suffix)));
    last_material = part.material;
    primitives.push_back(add_primitive(file, mesh, part, profile, gap));
    primitives.back()["material"] = number;
  }
  file.append("/meshes", {{"name", "lit surfaces"}, {"primitives", std::move(primitives)}});
}

}  // namespace

void export_glb(const std::filesystem::path& path, const PatchSet& patches, const Solution& solution,
                const SmoothLight& light, const Vec3& up, const ExportOptions& options) {
  const LitMesh mesh(patches, solution, light, options.tone);
  const auto profile = profile_of(options.program);
  GltfWriter file;
  file.put("/asset/generator", valid_utf8("Luxel " + solution.provenance.program_version));
  file.put("/asset/extras/luxel",
           light_metadata("vertex", options.program, vertex_light(mesh.curve(), profile), solution));
  if (!mesh.parts().empty()) {  // glTF allows no empty mesh
    file.use_extension("KHR_materials_unlit");
    add_mesh(file, patches, mesh, options.program);
    add_root(file, {{"name", "scene"}, {"mesh", 0}}, up, patches.origin);
    add_opening_bodies(file, patches, mesh.curve(), {"/nodes/0/children"});
  }
  write_glb(path, file, options.program, options.compression);
}

}  // namespace luxel
