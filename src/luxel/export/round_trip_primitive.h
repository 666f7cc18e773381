// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

#include "luxel/export/round_trip_surfaces.h"
#include "luxel/import/gltf_file.h"
#include "luxel/import/gltf_writer.h"

namespace luxel {

// The JSON path of a primitive.
std::string primitive_path(std::size_t mesh, std::size_t primitive);

// Gives a node its own copy of a mesh that another node shows too; returns the mesh. `taken`: [mesh] whether
// a node has it already.
std::size_t mesh_of_node(GltfWriter& copy, std::size_t node, std::vector<bool>& taken);

// Writes a surface's vertices and triangles to the primitive at `path`, a copy of the part's own:
// unchanged if possible, else with all its attributes, which are interpolated at new vertices.
// Backs face the other way; gap, m: how far they lie behind the fronts.
void put_surface(GltfWriter& copy, GltfFile& file, const RoundTripPart& part, const RoundTripSurface& surface,
                 const std::string& path, float gap);

}  // namespace luxel
