// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "luxel/import/gltf_packing.h"

namespace luxel {

// Returns a GLB whose meshes take fewer bytes, and look the same: see packed_column() and position_grids().
// The node of a mesh whose positions become integers gets a child of its name, which holds the mesh and the
// grid's scale and origin; the node itself, and so its pivot and its animations, stays as it is. Meshes with
// skins or morph targets, and all of a file with extensions that Luxel does not know, stay as they are; so
// does a file that would become larger. With
// meshopt the triangles and vertices are in another order. Throws InputError, naming `source`, where the file
// is damaged, and where it is to be compressed and Luxel was built without meshoptimizer.
std::string packed_glb(std::string glb, const std::string& source, const GltfPacking& packing);

}  // namespace luxel
