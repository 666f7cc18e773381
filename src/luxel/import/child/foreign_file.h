// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <assimp/Importer.hpp>
#include <assimp/scene.h>

namespace luxel {

enum class ForeignFormat { fbx, collada, max_3ds };

// A scene as Assimp reads it. Vertices, polygons and texture coordinates are those of the file; indices may
// be out of range and numbers infinite.
struct ForeignFile {
  std::filesystem::path path;
  ForeignFormat format = ForeignFormat::fbx;
  std::unique_ptr<Assimp::Importer> importer;  // owns the scene
  const aiScene* scene = nullptr;
  std::vector<std::string> messages;  // each "note SENTENCE" or "warning SENTENCE", for the user
};

// Reads a file by its ending: .fbx, .dae or .3ds. Throws InputError with Assimp's reason where it refuses the
// file.
ForeignFile read_foreign(const std::filesystem::path& path);

// The nodes of a name, in the order of the tree.
std::vector<const aiNode*> nodes_named(const aiNode& root, const aiString& name);

}  // namespace luxel
