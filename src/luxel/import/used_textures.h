// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/scene/scene.h"

namespace luxel {

// Removes the scene's textures that no material uses, and renumbers the others in the order in which
// materials first use them.
void keep_used_textures(Scene& scene);

}  // namespace luxel
