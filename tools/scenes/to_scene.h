// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/scene/scene.h"

#include "scenes/made_scene.h"

namespace luxel::scenes {

// The scene as the library takes it: a group for each object, its triangles sorted by paint; the paints that
// it uses as materials; the lights without a surface.
Scene to_scene(const MadeScene& made, const std::string& name);

}  // namespace luxel::scenes
