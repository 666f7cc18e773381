// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

#include "luxel/import/child/foreign_materials.h"

namespace luxel {

// Converts the meshes of a file to those of a GLB. A mesh that several nodes use is written once. Polygons
// are triangulated; points and lines are omitted.
class ForeignMeshes {
 public:
  ForeignMeshes(const ForeignFile& file, GltfWriter& glb, ForeignMaterials& materials)
      : file_(file), glb_(glb), materials_(materials) {}

  // Returns the mesh of a node; nothing where it has no triangles. Throws InputError where an index or a
  // coordinate is out of range.
  std::optional<std::size_t> of(const aiNode& node);

 private:
  Json primitive(const aiMesh& mesh);  // null without triangles

  const ForeignFile& file_;
  GltfWriter& glb_;
  ForeignMaterials& materials_;
  std::map<std::vector<unsigned>, std::optional<std::size_t>> made_;
  std::map<unsigned, Json> primitives_;
};

}  // namespace luxel
