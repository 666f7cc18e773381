// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace luxel {

/// The program for which a GLB is written. docs/baking.md describes each of them.
enum class TargetApplication { any, three, babylon, godot, blender, unity, unreal };

/// The words of the command line: any, three, babylon, godot, blender, unity, unreal.
std::string_view name(TargetApplication program);
std::optional<TargetApplication> target_application(std::string_view word);
std::span<const std::string_view> mesh_program_names();

/// Properties of a file for that program.
struct ExportProfile {
  /// The program reads custom attributes, so the irradiance is written (12 bytes per vertex).
  bool keeps_irradiance = true;
  /// Colours are stored in eight bits as sRGB, and the program decodes them where the name of the material
  /// has the suffix: fine steps in dark parts. This differs from glTF, whose vertex colours are linear.
  bool colours_are_srgb = false;
  std::string_view material_suffix = "";
  /// The program subtracts the specular reflection from the light of a lightmap, whether or not there is
  /// anything to reflect: therefore lightmapped surfaces are written without gloss.
  bool gloss_dims_lightmaps = false;
};

ExportProfile profile_of(TargetApplication program);

}  // namespace luxel
