// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "luxel/core/vector.h"
#include "luxel/import/json_value.h"

namespace luxel {

// A calculation area that a node of a glTF file describes by its extras: "calculation_area" is its kind, such
// as "task", and "area_..." are further keys.
struct AreaNode {
  std::string name, kind;
  Vec3d corner{0.0}, first{0.0}, second{0.0};  // of a rectangle, m, in the file's coordinates
  JsonValue extras;
};

// The extent of the node's mesh in the two axes in which it is largest; of a node without a mesh, the square
// of 1 m about its origin in its X-Z plane. Throws InputError where the file cannot be read.
std::vector<AreaNode> gltf_area_nodes(const std::filesystem::path& file);

// True if the node is a calculation area, whose mesh is no surface of the scene.
bool is_calculation_area(const JsonValue& node);

}  // namespace luxel
