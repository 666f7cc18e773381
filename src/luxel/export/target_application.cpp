// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/target_application.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace luxel {
namespace {

constexpr std::array<std::string_view, 7> names = {"any",     "three", "babylon", "godot",
                                                   "blender", "unity", "unreal"};

}  // namespace

std::string_view name(TargetApplication program) { return names[static_cast<std::size_t>(program)]; }

std::optional<TargetApplication> target_application(std::string_view word) {
  const auto found = std::find(names.begin(), names.end(), word);
  if (found == names.end()) return std::nullopt;
  return static_cast<TargetApplication>(found - names.begin());
}

std::span<const std::string_view> mesh_program_names() { return names; }

ExportProfile profile_of(TargetApplication program) {
  switch (program) {
    case TargetApplication::godot:
      // Its importer removes the suffix, and sets "use as albedo" and "is sRGB".
      return {.keeps_irradiance = false, .colours_are_srgb = true, .material_suffix = "-vcol"};
    case TargetApplication::three:
      return {.gloss_dims_lightmaps = true};
    case TargetApplication::babylon:
    case TargetApplication::unity:
    case TargetApplication::unreal:
      return {.keeps_irradiance = false};
    default:
      return {};
  }
}

}  // namespace luxel
