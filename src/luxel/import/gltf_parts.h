// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "luxel/import/gltf_file.h"
#include "luxel/import/placed_nodes.h"

namespace luxel {

// Extensions that a file may require: those that Luxel reads, and those that only change specular
// reflections, which Luxel does not compute.
const std::vector<std::string_view>& known_extensions();

// A primitive that draws triangles, where a node puts it.
struct GltfPart {
  PlacedNode placed;
  JsonValue primitive;
  std::size_t number = 0;  // of the mesh's primitives
  std::string object;      // what a person calls it
};

// The primitives that a scene draws, in the order in which its triangles are counted: node after node,
// primitive after primitive.
struct GltfParts {
  std::vector<GltfPart> parts;
  std::size_t without_triangles = 0, skinned = 0, morphed = 0;  // left out; taken as if they were not
};

// Throws InputError with the JSON path.
GltfParts drawn_parts(const GltfFile& file, const std::vector<PlacedNode>& nodes);

// Returns the vertices of each triangle as indices into the primitive's arrays, counter-clockwise where the
// node does not mirror: from lists, strips and fans, with and without indices. Throws InputError with the
// JSON path where an index is not below `vertices`.
std::vector<std::array<std::uint32_t, 3>> triangle_corners(GltfFile& file, const JsonValue& primitive,
                                                           std::size_t vertices);

// Returns whether the transform of a node reverses the winding of triangles.
bool mirrors(const glm::dmat4& world);

}  // namespace luxel
