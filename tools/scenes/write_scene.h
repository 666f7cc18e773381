// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "luxel/scene/scene.h"

#include "scenes/made_scene.h"

namespace luxel::scenes {

// A scene as Wavefront OBJ, a group for each object, and its materials as MTL. The first lines name its
// cameras as options of `luxel`. Numbers: metres to the micrometre. The sun and other lights without a
// surface are left out, and the first lines report it.
std::string obj_text(const Scene& scene, const MadeScene& about, const std::string& mtl_name);
std::string mtl_text(const Scene& scene);

// A scene as GLB with its cameras, and with its lights by emissive strength and KHR_lights_punctual.
std::string glb_bytes(const Scene& scene, const MadeScene& about);

// Writes FILE.obj and FILE.mtl, or FILE.glb; the folder is created. Throws InputError for another ending.
void write_scene(const std::filesystem::path& path, const MadeScene& scene);

}  // namespace luxel::scenes
