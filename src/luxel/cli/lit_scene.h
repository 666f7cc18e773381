// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "luxel/cli/console.h"
#include "luxel/cli/settings.h"
#include "luxel/patch/patch_set.h"
#include "luxel/scene/scene.h"

namespace luxel {

// "room.obj: 32 triangles, 4 materials, cut into 52,916 patches".
std::string describe_scene(const std::string& file, const Scene& scene, const PatchSet& patches);

// Loads the scene of the settings. Where it has no light and --sky is auto, it gets the default light
// (add_default_light()), which the console reports. Throws what load_scene() throws.
// up: "y", "z" or "auto", for luminaires that aim down.
Scene load_lit_scene(const SceneSettings& settings, const std::string& up, const Context& context,
                     Console& console);

}  // namespace luxel
