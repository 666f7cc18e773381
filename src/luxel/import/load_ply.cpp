// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/load_ply.h"

#include <algorithm>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/core/output_file.h"
#include "luxel/import/make_materials.h"
#include "luxel/import/name_list.h"
#include "luxel/import/polygon_scene.h"
#include "luxel/import/read_ply.h"

namespace luxel {
namespace {

void expect_faces(const PolygonMesh& mesh, const std::string& source) {
  if (!mesh.faces.empty()) return;
  if (mesh.short_faces.count > 0 || mesh.positions.empty())
    throw InputError(source, "no faces of three corners or more found");
  throw InputError(source, fmt::format("no faces found, but {}: a point cloud; make a mesh of it first, for "
                                       "example with MeshLab's surface reconstruction",
                                       counted(mesh.positions.size(), "vertex position")));
}

// The colours are factors of a reflectance that the scene caps: their products are the colours themselves.
void scale_colours(std::vector<Vec3>& colours, const LoadOptions& options, const std::string& source,
                   const Context& context) {
  std::size_t lowered = 0;
  for (auto& colour : colours) {
    const auto most = std::max({colour.r, colour.g, colour.b});
    if (most > options.max_reflectance) ++lowered;
    colour =
        options.max_reflectance > 0.0f ? glm::min(colour / options.max_reflectance, Vec3(1.0f)) : Vec3(1.0f);
  }
  if (lowered > 0)
    context.warn(fmt::format("{}: the reflectance of {} was lowered to {}, as no surface reflects all light",
                             source, counted(lowered, "colour"), options.max_reflectance));
}

MaterialLibrary materials_of(PlyMesh& ply, const std::filesystem::path& path, const LoadOptions& options,
                             const Context& context) {
  auto& mesh = ply.mesh;
  MaterialLibrary library;
  if (mesh.face_colours.size() != mesh.faces.size()) mesh.face_colours.clear();
  if (!ply.textures.empty()) {
    mesh.vertex_colours.clear();
    mesh.face_colours.clear();
    for (const auto& name : ply.textures) {
      MtlMaterial material;
      material.name = material.map_kd.name = name;
      library.entries.try_emplace(name, MaterialLibrary::Entry{std::move(material), path.parent_path()});
    }
    return library;
  }
  auto& colours = mesh.face_colours.empty() ? mesh.vertex_colours : mesh.face_colours;
  if (colours.empty()) {
    context.note(fmt::format("{}: the file has no colours; a grey of {} is taken", path.string(),
                             default_reflectance));
    return library;
  }
  scale_colours(colours, options, path.string(), context);
  MtlMaterial material;
  material.name = mesh.materials.front().name;
  material.kd = Vec3(options.max_reflectance);
  library.entries.try_emplace(material.name, MaterialLibrary::Entry{material, path.parent_path()});
  return library;
}

}  // namespace

Scene load_ply(const std::filesystem::path& path, const LoadOptions& options, const Context& context) {
  return load_ply(read_file(path), path, options, context);
}

Scene load_ply(std::string_view bytes, const std::filesystem::path& path, const LoadOptions& options,
               const Context& context) {
  const auto source = path.string();
  auto ply = read_ply(bytes, source, options.scale, context);
  if (!ply) return {};
  expect_faces(ply->mesh, source);
  const auto library = materials_of(*ply, path, options, context);
  return scene_of(ply->mesh, library, source, options, context);
}

}  // namespace luxel
