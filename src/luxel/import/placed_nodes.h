// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "luxel/core/vector.h"
#include "luxel/import/gltf_file.h"

namespace luxel {

// A node of a glTF scene and where it stands.
struct PlacedNode {
  JsonValue node;
  std::size_t number = 0;              // of the file's nodes
  glm::dmat4 world = glm::dmat4(1.0);  // from the node's coordinates to the scene's
};

// The nodes of the file's scene (of its first one where it names none, of all roots where it has none), each
// before its children. Throws InputError where a node is reached twice: glTF's nodes are trees.
std::vector<PlacedNode> placed_nodes(const GltfFile& file);

}  // namespace luxel
