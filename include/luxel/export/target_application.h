// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace luxel {

/// The program that a GLB is for: glTF is read with profile. docs/baking.md has what each of them does.
enum class TargetApplication { any, three, babylon, godot, blender, unity, unreal };

/// The words of the command line: any, three, babylon, godot, blender, unity, unreal.
std::string_view name(TargetApplication program);
std::optional<TargetApplication> target_application(std::string_view word);
std::span<const std::string_view> mesh_program_names();

/// What a file is made like for it.
struct ExportProfile {
  /// Attributes of one's own are read, so that the irradiance is worth its 12 bytes per vertex.
  bool keeps_irradiance = true;
  /// Colours are stored in eight bits, and the program decodes sRGB when it is told by the name of a
  /// material: so the dark is not cut into steps. Against glTF, which wants them linear.
  bool colours_are_srgb = false;
  std::string_view material_suffix = "";
  /// What gloss would send back is taken off a lightmap's light, whether there is anything to mirror or not:
  /// so a lightmapped surface has no gloss.
  bool gloss_dims_lightmaps = false;
};

ExportProfile profile_of(TargetApplication program);

}  // namespace luxel
