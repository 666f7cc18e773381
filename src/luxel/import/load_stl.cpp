// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/load_stl.h"

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/core/output_file.h"
#include "luxel/import/make_materials.h"
#include "luxel/import/polygon_scene.h"
#include "luxel/import/read_stl.h"

namespace luxel {

Scene load_stl(const std::filesystem::path& path, const LoadOptions& options, const Context& context) {
  return load_stl(read_file(path), path, options, context);
}

Scene load_stl(std::string_view bytes, const std::filesystem::path& path, const LoadOptions& options,
               const Context& context) {
  const auto source = path.string();
  const auto mesh = read_stl(bytes, source, options.scale, context);
  if (!mesh) return {};
  if (mesh->faces.empty()) throw InputError(source, "no triangles found");
  context.note(fmt::format("{}: STL has no colours; a grey of {} is taken", source, default_reflectance));
  return scene_of(*mesh, {}, source, options, context);
}

}  // namespace luxel
