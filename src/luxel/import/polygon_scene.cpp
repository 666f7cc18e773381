// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/polygon_scene.h"

#include <fmt/format.h>

#include "luxel/import/make_materials.h"
#include "luxel/import/make_triangles.h"
#include "luxel/import/name_list.h"
#include "luxel/import/place_positions.h"

namespace luxel {
namespace {

void say(const Tally& tally, const char* noun, const char* what, const char* consequence,
         const std::string& source, const Context& context) {
  if (tally.count == 0) return;
  const auto where = tally.first_line > 0 ? fmt::format(" (first: line {})", tally.first_line) : "";
  context.warn(fmt::format("{}: {} {}{}; {}", source, counted(tally.count, noun), what, where, consequence));
}

}  // namespace

Scene scene_of(const PolygonMesh& mesh, const MaterialLibrary& library, const std::string& source,
               const LoadOptions& options, const Context& context) {
  Scene scene;
  scene.source = source;
  Reach reach;
  for (const auto& corner : mesh.corners) reach.add(mesh.positions[corner.position]);
  place_positions(mesh.positions, reach, options.scale, scene);
  scene.groups = mesh.groups;
  scene.objects = mesh.objects;
  make_materials(mesh.materials, library, options, scene, context);
  const auto tallies = make_triangles(mesh, scene, context);
  if (!tallies) return {};

  say(mesh.short_faces, "face", "of fewer than three corners", "dropped", source, context);
  say(mesh.faces_without_material, "face", "before any usemtl", "the material 'default' is taken", source,
      context);
  say(mesh.unreadable_normals, "vertex normal", "not of three finite numbers", "passed over", source,
      context);
  if (!scene.uv_sets.empty())
    say(mesh.unreadable_uvs, "texture coordinate", "not of finite numbers", "0 is taken", source, context);
  say(tallies->without_uv, "face", "of textured materials without texture coordinates",
      "the mean colours are taken", source, context);
  say(tallies->turned, "triangle", "wound against the vertex normals", "turned round", source, context);
  return scene;
}

}  // namespace luxel
