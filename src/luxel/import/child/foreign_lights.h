// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "luxel/core/json.h"
#include "luxel/import/child/foreign_file.h"
#include "luxel/import/gltf_writer.h"

namespace luxel {

// The nodes of a GLB for the punctual lights and the cameras of a file, by the node that each belongs to.
//
// The intensities of these formats have no unit. They are taken as Blender writes them: watts of radiant
// power of point and spot lights (of a spot without its cone), W/m² of directional ones; glTF then has
// candela and lux. FBX gives 100 times the intensity, which Assimp divides. Area and ambient lights are
// omitted, with a warning.
using AttachedNodes = std::map<const aiNode*, std::vector<Json>>;
AttachedNodes attached_nodes(ForeignFile& file, GltfWriter& glb);

}  // namespace luxel
