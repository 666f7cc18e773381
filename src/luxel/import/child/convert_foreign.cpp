// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/child/convert_foreign.h"

#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/import/child/file_frame.h"
#include "luxel/import/child/foreign_lights.h"
#include "luxel/import/child/foreign_meshes.h"

namespace luxel {
namespace {

class NodeWriter {
 public:
  NodeWriter(ForeignFile& file, GltfWriter& glb)
      : glb_(glb),
        materials_(file, glb),
        meshes_(file, glb, materials_),
        attached_(attached_nodes(file, glb)) {}

  // Returns the number of the node; its children stand before it.
  std::size_t write(const aiNode& node, const aiMatrix4x4& placement);
  void finish() { materials_.finish(); }

 private:
  GltfWriter& glb_;
  ForeignMaterials materials_;
  ForeignMeshes meshes_;
  AttachedNodes attached_;
};

// By columns.
Json matrix_of(const aiNode& node, const aiMatrix4x4& m) {
  auto numbers = Json::array();
  for (unsigned column = 0; column < 4; ++column)
    for (unsigned row = 0; row < 4; ++row) {
      if (!std::isfinite(m[row][column]))
        throw InputError(fmt::format("the node '{}' has a transform that is not finite", node.mName.C_Str()));
      numbers.push_back(m[row][column]);
    }
  return numbers;
}

std::size_t NodeWriter::write(const aiNode& node, const aiMatrix4x4& placement) {
  // Assimp divides the transform of an FBX node among several nodes, and marks the names of the added ones.
  constexpr std::string_view added = "$AssimpFbx$";
  const std::string_view name = node.mName.C_Str();
  Json made;
  if (name.find(added) == name.npos && !name.empty()) made["name"] = name;
  made["matrix"] = matrix_of(node, placement);
  if (const auto mesh = meshes_.of(node)) made["mesh"] = *mesh;
  auto children = Json::array();
  for (unsigned i = 0; i < node.mNumChildren; ++i)
    children.push_back(write(*node.mChildren[i], node.mChildren[i]->mTransformation));
  if (const auto found = attached_.find(&node); found != attached_.end())
    for (const auto& child : found->second) children.push_back(glb_.append("/nodes", child));
  if (!children.empty()) made["children"] = std::move(children);
  return glb_.append("/nodes", made);
}

}  // namespace

ConvertedFile convert_foreign(const std::filesystem::path& path) {
  auto file = read_foreign(path);
  GltfWriter glb;
  NodeWriter nodes(file, glb);
  const auto& root = *file.scene->mRootNode;
  const auto number = nodes.write(root, file_frame(file) * root.mTransformation);
  nodes.finish();
  glb.append("/scenes", {{"nodes", {number}}});
  glb.put("/scene", 0);
  return {glb.bytes(path.string()), std::move(file.messages)};
}

}  // namespace luxel
