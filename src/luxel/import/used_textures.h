// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/scene/scene.h"

namespace luxel {

// Drops the scene's textures that no material uses, and numbers the uses of the others anew, in the order in
// which materials first have them.
void keep_used_textures(Scene& scene);

}  // namespace luxel
