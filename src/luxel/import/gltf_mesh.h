// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "luxel/import/gltf_array.h"
#include "luxel/import/placed_nodes.h"
#include "luxel/scene/scene.h"

namespace luxel {

// The triangles of placed meshes, primitive after primitive, on their way into a Scene.
class GltfMesh {
 public:
  // scale: metres per unit of the file. texture_coordinates: the n of TEXCOORD_n of each of the scene's sets.
  GltfMesh(GltfFile& file, Scene& scene, double scale, std::vector<std::size_t> texture_coordinates);

  // Adds a primitive that draws triangles, with all of its arrays, at its place. Throws InputError with the
  // JSON path where an index or a number is out of range.
  void add(const JsonValue& primitive, const glm::dmat4& world, const std::string& object,
           MaterialId material);

  // Per corner, in the file's units: the scene's own positions are computed when all are known.
  const std::vector<Vec3d>& positions() const { return positions_; }

  // Drops colours that are all white, which have no effect.
  void finish();

 private:
  Vec3d placed(const GltfArray& positions, std::size_t vertex, const glm::dmat4& world) const;
  std::uint32_t number_of(const std::string& object);
  void add_uvs(const JsonValue& primitive, const std::vector<std::array<std::uint32_t, 3>>& corners);
  void add_colours(const JsonValue& primitive, const std::vector<std::array<std::uint32_t, 3>>& corners);

  GltfFile& file_;
  Scene& scene_;
  double scale_;
  std::vector<std::size_t> texture_coordinates_;
  std::vector<Vec3d> positions_;
  std::map<std::string, std::uint32_t> objects_;
  bool has_colours_ = false;
};

}  // namespace luxel
