// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/child/foreign_meshes.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include <assimp/mesh.h>
#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/import/polygon.h"

namespace luxel {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

std::vector<Vec3> positions_of(const aiMesh& mesh) {
  std::vector<Vec3> positions;
  positions.reserve(mesh.mNumVertices);
  for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
    const auto& p = mesh.mVertices[i];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      throw InputError(fmt::format("vertex {} of the mesh '{}' has a coordinate that is not finite", i,
                                   mesh.mName.C_Str()));
    positions.emplace_back(p.x, p.y, p.z);
  }
  return positions;
}

// Texture coordinates run upwards here and downwards in glTF.
std::vector<Vec2> coordinates_of(const aiMesh& mesh, unsigned set) {
  std::vector<Vec2> coordinates;
  coordinates.reserve(mesh.mNumVertices);
  for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
    const auto& uv = mesh.mTextureCoords[set][i];
    const bool is_finite = std::isfinite(uv.x) && std::isfinite(uv.y);
    coordinates.push_back(is_finite ? Vec2(uv.x, 1.0f - uv.y) : Vec2(0.0f));
  }
  return coordinates;
}

void add_face(const aiMesh& mesh, const aiFace& face, const std::vector<Vec3>& positions,
              std::vector<Triangle>& triangles) {
  if (face.mNumIndices < 3) return;
  std::vector<Vec3> corners;
  for (unsigned i = 0; i < face.mNumIndices; ++i) {
    if (face.mIndices[i] >= positions.size())
      throw InputError(fmt::format("a face of the mesh '{}' names vertex {}, but there are only {}",
                                   mesh.mName.C_Str(), face.mIndices[i], positions.size()));
    corners.push_back(positions[face.mIndices[i]]);
  }
  const auto first = triangles.size();
  triangulate_polygon(corners, triangles);
  for (auto t = first; t < triangles.size(); ++t)
    for (auto& corner : triangles[t]) corner = face.mIndices[corner];
}

}  // namespace

Json ForeignMeshes::primitive(const aiMesh& mesh) {
  if (!mesh.HasPositions() || !mesh.HasFaces()) return nullptr;
  const auto positions = positions_of(mesh);
  std::vector<Triangle> triangles;
  for (unsigned i = 0; i < mesh.mNumFaces; ++i) add_face(mesh, mesh.mFaces[i], positions, triangles);
  if (triangles.empty()) return nullptr;
  Json made;
  if (const auto material = materials_.of(mesh.mMaterialIndex)) made["material"] = *material;
  auto& attributes = made["attributes"];
  attributes["POSITION"] = glb_.add_positions(positions);
  const auto sets = materials_.coordinates(mesh.mMaterialIndex);
  for (unsigned set = 0; set < sets; ++set) {
    // Some files name a set by a number that the mesh does not have; its first one is meant.
    const auto own = mesh.HasTextureCoords(set) ? set : 0;
    if (mesh.HasTextureCoords(own))
      attributes[fmt::format("TEXCOORD_{}", set)] =
          glb_.add_vectors(std::span<const Vec2>(coordinates_of(mesh, own)));
  }
  made["indices"] = glb_.add_indices(triangles, positions.size());
  return made;
}

std::optional<std::size_t> ForeignMeshes::of(const aiNode& node) {
  const std::vector<unsigned> numbers(node.mMeshes, node.mMeshes + node.mNumMeshes);
  if (const auto found = made_.find(numbers); found != made_.end()) return found->second;
  auto all = Json::array();
  for (const auto number : numbers) {
    if (number >= file_.scene->mNumMeshes)
      throw InputError(fmt::format("the node '{}' names mesh {}, but there are only {}", node.mName.C_Str(),
                                   number, file_.scene->mNumMeshes));
    const auto [place, is_new] = primitives_.try_emplace(number);
    if (is_new) place->second = primitive(*file_.scene->mMeshes[number]);
    if (!place->second.is_null()) all.push_back(place->second);
  }
  auto& made = made_[numbers];
  if (!all.empty()) made = glb_.append("/meshes", {{"primitives", std::move(all)}});
  return made;
}

}  // namespace luxel
