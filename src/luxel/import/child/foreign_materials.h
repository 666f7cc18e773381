// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <assimp/material.h>

#include "luxel/import/child/foreign_pictures.h"

namespace luxel {

// Converts the materials of a file to those of a GLB, at their first use. Colours are linear. Emission
// without a unit is radiance in W/(m² sr), as Ke of OBJ. All are two-sided, as in OBJ: FBX and 3DS as Assimp
// reads them do not state it, and for COLLADA it does not report whether a file does.
class ForeignMaterials {
 public:
  ForeignMaterials(ForeignFile& file, GltfWriter& glb) : file_(file), glb_(glb), pictures_(file, glb) {}

  // Returns the material of a mesh; nothing where the file gives it none.
  std::optional<std::size_t> of(unsigned number);

  // The number of texture coordinates that the textures of a material use.
  unsigned coordinates(unsigned number) const;

  // Adds what was replaced or ignored to the messages of the file.
  void finish();

 private:
  std::optional<std::size_t> add(const aiMaterial& material, unsigned number);
  Json texture(const aiMaterial& material, std::initializer_list<aiTextureType> types, unsigned number);
  void add_alpha(const aiMaterial& material, const std::string& name, Json& made);

  ForeignFile& file_;
  GltfWriter& glb_;
  ForeignPictures pictures_;
  std::map<unsigned, std::optional<std::size_t>> made_;
  std::map<unsigned, unsigned> coordinates_;
  std::vector<std::string> invisible_, with_opacity_picture_;  // names, for the messages
};

}  // namespace luxel
