// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/target_application.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "luxel/import/meshopt_encode.h"

namespace luxel {
namespace {

constexpr std::array<std::string_view, 7> names = {"any",     "three", "babylon", "godot",
                                                   "blender", "unity", "unreal"};
constexpr std::array<std::string_view, 3> compression_names = {"none", "quantize", "meshopt"};

}  // namespace

std::string_view name(TargetApplication program) { return names[static_cast<std::size_t>(program)]; }

std::optional<TargetApplication> target_application(std::string_view word) {
  const auto found = std::find(names.begin(), names.end(), word);
  if (found == names.end()) return std::nullopt;
  return static_cast<TargetApplication>(found - names.begin());
}

std::span<const std::string_view> mesh_program_names() { return names; }

std::string_view name(MeshCompression compression) {
  return compression_names[static_cast<std::size_t>(compression)];
}

std::optional<MeshCompression> mesh_compression(std::string_view word) {
  const auto found = std::find(compression_names.begin(), compression_names.end(), word);
  if (found == compression_names.end()) return std::nullopt;
  return static_cast<MeshCompression>(found - compression_names.begin());
}

std::span<const std::string_view> mesh_compression_names() { return compression_names; }

bool is_available(MeshCompression compression) {
  return compression != MeshCompression::meshopt || has_meshopt();
}

ExportProfile profile_of(TargetApplication program) {
  switch (program) {
    case TargetApplication::godot:
      // Its importer removes the suffix, and sets "use as albedo" and "is sRGB".
      return {.keeps_irradiance = false,
              .colours_are_srgb = true,
              .material_suffix = "-vcol",
              .reads_quantised = false,
              .reads_meshopt = false};
    case TargetApplication::three:
      return {.gloss_dims_lightmaps = true};
    case TargetApplication::babylon:
    case TargetApplication::unity:
      return {.keeps_irradiance = false};
    case TargetApplication::blender:
      return {.shows_both_faces = true, .reads_meshopt = false};  // Cycles
    case TargetApplication::unreal:
      return {.keeps_irradiance = false, .reads_quantised = false, .reads_meshopt = false};
    default:
      return {};
  }
}

}  // namespace luxel
