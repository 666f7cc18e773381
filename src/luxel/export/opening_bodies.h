// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "luxel/image/tone.h"
#include "luxel/import/gltf_writer.h"
#include "luxel/patch/patch_set.h"

namespace luxel {

// The parent of added nodes.
struct NodeParent {
  std::string children;          // path of an array of nodes; empty: of a file without scenes
  double metres_per_unit = 1.0;  // of the file
  Vec3d origin{0.0};             // m, in the parent's axes: where the patches' coordinates begin
};

// Adds the luminous opening of each luminaire as a node with a mesh that emits, so that programs show where
// the light comes from; one mesh per photometric file and colours. Its faces have the colours of
// opening_faces() after the tone curve. The extras of a mesh have `luxel_opening`: Luxel ignores such meshes
// when it reads a file, since the light is that of the luminaire. Bodies of an earlier export are removed.
// Without luminaires the file is not changed.
void add_opening_bodies(GltfWriter& file, const PatchSet& patches, const ToneCurve& curve,
                        const NodeParent& parent);

}  // namespace luxel
