// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/load_obj.h"

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/import/material_library.h"
#include "luxel/import/name_list.h"
#include "luxel/import/polygon_scene.h"
#include "luxel/import/read_obj.h"
#include "luxel/import/text.h"

namespace luxel {
namespace {

void expect_faces(const PolygonMesh& mesh, std::string_view text, const std::string& source) {
  if (text.empty()) throw InputError(source, "no faces found; the file is empty");
  if (mesh.faces.empty())
    throw InputError(source,
                     fmt::format("no faces found; expected lines such as 'f 1 2 3', found {}{}",
                                 counted(mesh.positions.size(), "vertex position"),
                                 mesh.short_faces.count > 0 ? " and faces of fewer than three corners" : ""));
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
  const auto library =
      read_libraries(mesh->libraries, path, SceneFolder(path, options.allow_outside), context);
  return scene_of(*mesh, library, source, options, context);
}

}  // namespace luxel
