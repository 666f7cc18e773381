// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "luxel/scene/scene.h"

namespace luxel {

// A scene as a GLB without light.
struct SceneGltf {
  std::string bytes;
  std::vector<std::uint32_t> order;  // [triangle of the file]: that of the scene
};

// Converts a scene that was not glTF: a node for each object (each group, where the file names none), below a
// root that turns `up` to +Y and restores the file's origin; materials with their names, colours and
// textures, holes too; TEXCOORD_0 where a material has a texture. Lamps are surfaces that emit, nits. Throws
// InputError where up has no length or the scene is beyond the 4 GiB of a GLB.
SceneGltf gltf_of(const Scene& scene, const Vec3& up);

}  // namespace luxel
