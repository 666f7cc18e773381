// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "luxel/core/vector.h"
#include "luxel/export/target_application.h"
#include "luxel/import/gltf_writer.h"
#include "luxel/import/json_value.h"

namespace luxel {

// The materials of a glTF file, changed to show computed light. Each is changed once, or once per page of a
// lightmap on which it appears and per set of texture coordinates.
class RoundTripMaterials {
 public:
  // Keeps references.
  RoundTripMaterials(GltfWriter& copy, TargetApplication program) : copy_(copy), program_(program) {}

  // Returns whether a texture still colours the reflection of the primitive's material.
  static bool is_textured(const JsonValue& material);

  // Each assigns the primitive at `path` its material: that of the file with this `index`, changed; or a new
  // one where there is no index.
  //
  // Unlit, the base colour white: the vertex colours are shown, times the texture. Returns the path of the
  // material if it was made or changed now.
  std::optional<std::string> shadeless(const std::string& path, const JsonValue& index);
  // Lit by a texture. intensity: irradiance of a texel of 1, after the display's scale. emission: of the
  // surface itself, on the same scale.
  void lightmapped(const std::string& path, const JsonValue& index, std::size_t texture,
                   std::size_t coordinates, float intensity, const Vec3& emission);
  // Black, and emissive by the texture.
  void shining(const std::string& path, const JsonValue& index, std::size_t texture, std::size_t coordinates);

  // Visible from the front only, since backs have separate triangles.
  void one_sided(const std::string& path);

 private:
  std::optional<std::string> changed_for(const std::string& path, const JsonValue& index, std::size_t texture,
                                         std::size_t coordinates);
  void plain_base(const std::string& material);
  void take_gloss_off(const std::string& material);
  void take_extensions_off(const std::string& material);
  void colour_base(const std::string& material, int grey, double roughness);  // alpha stays

  GltfWriter& copy_;
  TargetApplication program_;
  std::map<std::array<std::size_t, 3>, std::size_t> made_;  // material of the file, texture, coordinates
  std::vector<bool> taken_;                                 // [material of the file]
};

}  // namespace luxel
