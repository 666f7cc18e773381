// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/cli/console.h"
#include "luxel/cli/settings.h"
#include "luxel/scene/scene.h"

namespace luxel {

// Loads the scene of the settings. Where it has no light and --sky is auto, it gets the default light
// (add_default_light()), which the console reports. Throws what load_scene() throws.
Scene load_lit_scene(const SceneSettings& settings, const Context& context, Console& console);

}  // namespace luxel
