// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "luxel/patch/patch_set.h"
#include "luxel/scene/scene.h"

namespace luxel {

// For each patch the number of the face of the file that it is part of, from 0. Patches of one face share a
// number where the face is flat and none of its triangles was cut into several patches; all others have a
// number of their own. In scenes without lines (Scene::triangle_line) every triangle is a face.
std::vector<std::uint32_t> uncut_faces(const Scene& scene, const PatchSet& patches);

}  // namespace luxel
