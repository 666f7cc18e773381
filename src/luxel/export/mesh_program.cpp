// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/mesh_program.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace luxel {
namespace {

constexpr std::array<std::string_view, 7> names = {"any",     "three", "babylon", "godot",
                                                   "blender", "unity", "unreal"};

}  // namespace

std::string_view name(MeshProgram program) { return names[static_cast<std::size_t>(program)]; }

std::optional<MeshProgram> mesh_program(std::string_view word) {
  const auto found = std::find(names.begin(), names.end(), word);
  if (found == names.end()) return std::nullopt;
  return static_cast<MeshProgram>(found - names.begin());
}

std::span<const std::string_view> mesh_program_names() { return names; }

MeshHabits habits_of(MeshProgram program) {
  switch (program) {
    case MeshProgram::godot:
      // Its importer takes the suffix off again, and sets "use as albedo" and "is sRGB".
      return {.keeps_irradiance = false, .colours_are_srgb = true, .material_suffix = "-vcol"};
    case MeshProgram::three:
      return {.gloss_dims_lightmaps = true};
    case MeshProgram::babylon:
    case MeshProgram::unity:
    case MeshProgram::unreal:
      return {.keeps_irradiance = false};
    default:
      return {};
  }
}

}  // namespace luxel
