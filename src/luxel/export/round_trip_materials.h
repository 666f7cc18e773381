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
#include "luxel/import/gltf_copy.h"
#include "luxel/import/json_value.h"

namespace luxel {

// The materials of a glTF file, changed so that they show light that is known. Each is changed once, or once
// for each page of a lightmap that it is seen on and each set of coordinates that says where.
class RoundTripMaterials {
 public:
  // Keeps references.
  RoundTripMaterials(GltfCopy& copy, TargetApplication program) : copy_(copy), program_(program) {}

  // Whether a texture goes on colouring what the primitive's material reflects.
  static bool is_textured(const JsonValue& material);

  // Each gives the primitive at `path` its material: that of the file which `index` names, changed; or one
  // made for it, where there is no index.
  // Shadeless, the base colour white: what the vertices say is what is seen, but for the texture.
  void shadeless(const std::string& path, const JsonValue& index);
  // Lit by a texture: of so much irradiance where it is 1, after the display's scale. emission: of the
  // surface itself, likewise.
  void lightmapped(const std::string& path, const JsonValue& index, std::size_t texture,
                   std::size_t coordinates, float intensity, const Vec3& emission);
  // Black, and shining as the texture says.
  void shining(const std::string& path, const JsonValue& index, std::size_t texture, std::size_t coordinates);

  // Seen from the front only, for what is behind has triangles of its own.
  void one_sided(const std::string& path);

 private:
  std::optional<std::string> changed_for(const std::string& path, const JsonValue& index, std::size_t texture,
                                         std::size_t coordinates);
  void plain_base(const std::string& material);
  void take_gloss_off(const std::string& material);
  void take_extensions_off(const std::string& material);
  void colour_base(const std::string& material, int grey, double roughness);  // alpha stays

  GltfCopy& copy_;
  TargetApplication program_;
  std::map<std::array<std::size_t, 3>, std::size_t> made_;  // material of the file, texture, coordinates
  std::vector<bool> taken_;                                 // [material of the file]
};

}  // namespace luxel
