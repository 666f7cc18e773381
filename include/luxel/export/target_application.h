// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace luxel {

/// The program for which a GLB is written. docs/baking.md describes each of them.
enum class TargetApplication { any, three, babylon, godot, blender, unity, unreal };

/// Returns the word of the command line: any, three, babylon, godot, blender, unity, unreal.
std::string_view name(TargetApplication program);
std::optional<TargetApplication> target_application(std::string_view word);
std::span<const std::string_view> mesh_program_names();

/// How the arrays of a GLB are stored: plain: positions, normals and texture coordinates as floats;
/// quantised: as integers of 8 and 16 bits (KHR_mesh_quantization); meshopt: these, compressed
/// (EXT_meshopt_compression). docs/baking.md has the errors.
enum class MeshCompression { plain, quantised, meshopt };

/// Returns the word of the command line: none, quantize, meshopt.
std::string_view name(MeshCompression compression);
std::optional<MeshCompression> mesh_compression(std::string_view word);
std::span<const std::string_view> mesh_compression_names();

/// Returns whether this build of Luxel can compress: MeshCompression::meshopt needs meshoptimizer.
bool is_available(MeshCompression compression);

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
  /// The program reads KHR_mesh_quantization. Otherwise only colours and texture coordinates become integers,
  /// as they may in every glTF file.
  bool reads_quantised = true;
  /// The program shows a triangle from both sides, whatever its material says.
  bool shows_both_faces = false;
  /// The program reads EXT_meshopt_compression. Otherwise the file is not compressed.
  bool reads_meshopt = true;
};

ExportProfile profile_of(TargetApplication program);

}  // namespace luxel
