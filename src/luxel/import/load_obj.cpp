// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/load_obj.h"

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/import/make_materials.h"
#include "luxel/import/make_triangles.h"
#include "luxel/import/material_library.h"
#include "luxel/import/name_list.h"
#include "luxel/import/place_positions.h"
#include "luxel/import/read_obj.h"
#include "luxel/import/text.h"

namespace luxel {
namespace {

void expect_faces(const ObjMesh& mesh, std::string_view text, const std::string& source) {
  if (text.empty()) throw InputError(source, "no faces found; the file is empty");
  if (mesh.faces.empty())
    throw InputError(source,
                     fmt::format("no faces found; expected lines such as 'f 1 2 3', found {}{}",
                                 counted(mesh.positions.size(), "vertex position"),
                                 mesh.short_faces.count > 0 ? " and faces of fewer than three corners" : ""));
}

void say(const Tally& tally, const char* noun, const char* what, const char* consequence,
         const std::string& source, const Context& context) {
  if (tally.count == 0) return;
  context.warn(fmt::format("{}: {} {} (first: line {}); {}", source, counted(tally.count, noun), what,
                           tally.first_line, consequence));
}

}  // namespace

Scene load_obj(const std::filesystem::path& path, const LoadOptions& options, const Context& context) {
  const auto text = read_text(path, path.string());
  return load_obj(text, path, options, context);
}

Scene load_obj(std::string_view text, const std::filesystem::path& path, const LoadOptions& options,
               const Context& context) {
  const auto source = path.string();
  const auto mesh = read_obj(text, source, options.scale, context);
  if (!mesh) return {};
  expect_faces(*mesh, text, source);

  Scene scene;
  scene.source = source;
  Reach reach;
  for (const auto& corner : mesh->corners) reach.add(mesh->positions[corner.position]);
  place_positions(mesh->positions, reach, options.scale, scene);
  scene.groups = mesh->groups;
  scene.objects = mesh->objects;
  const auto library = read_libraries(mesh->libraries, path, context);
  make_materials(mesh->materials, library, options, scene, context);
  const auto tallies = make_triangles(*mesh, scene, context);
  if (!tallies) return {};

  say(mesh->short_faces, "face", "of fewer than three corners", "dropped", source, context);
  say(mesh->faces_without_material, "face", "before any usemtl", "the material 'default' is taken", source,
      context);
  say(mesh->unreadable_normals, "vertex normal", "not of three finite numbers", "passed over", source,
      context);
  if (!scene.uv_sets.empty())
    say(mesh->unreadable_uvs, "texture coordinate", "not of finite numbers", "0 is taken", source, context);
  say(tallies->without_uv, "face", "of textured materials without texture coordinates",
      "the mean colours are taken", source, context);
  say(tallies->turned, "triangle", "wound against the vertex normals", "turned round", source, context);
  return scene;
}

}  // namespace luxel
