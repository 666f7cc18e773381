// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

#include "luxel/patch/patch_set.h"
#include "luxel/scene/scene.h"

namespace luxel {

// Words of a focus that are no names.
inline constexpr const char* focus_on_all = "all";
inline constexpr const char* focus_on_camera = "camera";

// Returns whether a patch is of a material, an object or a group whose name matches the pattern (* and ? as
// in name_pattern.h). Without a scene only materials have names.
bool is_called(const Scene* scene, const PatchSet& patches, std::size_t patch, const std::string& pattern);

// Sets where the error of the light matters (PatchSet::focus, focuses_on_cameras): everywhere, where the
// cameras of the patches see, or on the surfaces whose material, object or group has a name that matches the
// pattern (* and ? as in name_pattern.h). Throws InputError where there is no camera, or nothing of that
// name.
void set_focus(const Scene& scene, const std::string& focus, PatchSet& patches);

}  // namespace luxel
