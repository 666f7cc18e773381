// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/import/gltf_textures.h"
#include "luxel/import/load_scene.h"

namespace luxel {

// The materials that primitives of a glTF file use, created at their first use. Properties that are not
// supported become a warning, one per kind.
class GltfMaterials {
 public:
  GltfMaterials(GltfFile& file, const LoadOptions& options);

  // Returns the material of a primitive. A primitive without the texture coordinates that its material needs
  // gets the mean colours instead, as a material of its own.
  MaterialId of(const JsonValue& primitive);

  // The n of TEXCOORD_n of each set that uses name.
  const std::vector<std::size_t>& texture_coordinates() const { return texture_coordinates_; }

  // Gives the scene the materials and their textures.
  void give(Scene& scene);
  void say_warnings(const Context& context) const;

 private:
  // A picture where a glTF material may name one.
  struct TextureInput {
    bool is_given = false;
    std::optional<std::uint32_t> texture = {};  // nothing where it cannot be had
    std::optional<TextureUse> use = {};         // nothing where the primitive has no coordinates for it
  };
  struct Surface;  // a glTF material before its conversion

  Surface read(const JsonValue& json, const JsonValue& attributes);
  TextureInput texture_input(const JsonValue& info, const JsonValue& attributes);
  std::uint32_t set_of(std::size_t coordinates);
  Material make(const Surface& surface);
  void reflect(const Surface& surface, Material& material);
  float diffuse_fraction(const Surface& surface, TextureInput& base, Material& material);
  static void light_mirror(const JsonValue& specular, Surface& surface);
  void emit(const Surface& surface, Material& material) const;
  void read_diffuse_transmission(const JsonValue& json, Surface& surface);
  void let_through(const Surface& surface, Material& material);
  Vec3 transmittance_of(const Surface& surface);
  void cap(Material& material);
  MaterialId add(Material material);

  GltfFile& file_;
  const LoadOptions& options_;
  GltfTextures textures_;
  std::vector<Material> materials_;
  // Key: number in the file, and the pictures for which the primitive has no coordinates.
  std::map<std::pair<std::size_t, std::vector<bool>>, MaterialId> made_;
  std::vector<std::size_t> texture_coordinates_;
  std::optional<MaterialId> default_;  // of primitives without material

  // Names of materials, for the warnings.
  std::vector<std::string> too_bright_, transparent_, panes_, blended_, unlit_, metals_, without_coordinates_,
      diffusers_, too_bright_diffusers_;
};

}  // namespace luxel
