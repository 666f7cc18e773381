// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "luxel/import/gltf_parts.h"
#include "luxel/scene/scene.h"

namespace luxel {

// A primitive of a glTF file at one of its nodes, and the scene's triangles that it draws.
struct RoundTripPart {
  GltfPart drawn;
  std::size_t vertices = 0;  // of the primitive's arrays, and after them middles of two vertices:
  std::vector<std::array<std::uint32_t, 2>> halved;
  std::vector<std::uint32_t> triangles;               // [triangle of the primitive]: that of the scene
  std::vector<std::array<std::uint32_t, 3>> corners;  // [triangle]: vertices of the primitive, in the order
                                                      // of the scene's corners
  bool mirrored = false;                              // the file winds its triangles the other way
  bool as_read = true;                                // no triangle was turned since

  std::size_t vertices_of_file() const { return vertices - halved.size(); }
};

// Returns whether the part draws triangles, all of them opaque. A part has one material.
bool is_opaque(const Scene& scene, const RoundTripPart& part);

// Returns the parts of the file from which a scene was read, or which was made from it. order: [triangle of
// the file] that of the scene; empty: the same. Throws InputError as reading it does, MismatchError where the
// scene has other triangles than the file.
std::vector<RoundTripPart> round_trip_parts(GltfFile& file, const Scene& scene, double metres_per_unit,
                                            const std::vector<std::uint32_t>& order);

}  // namespace luxel
