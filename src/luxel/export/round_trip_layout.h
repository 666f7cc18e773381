// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "luxel/patch/patch_set.h"
#include "luxel/scene/scene.h"
#include "luxel/surface/given_layout.h"

namespace luxel {

// The set of texture coordinates for lightmaps, by convention of programs.
inline constexpr const char* lightmap_coordinates = "TEXCOORD_1";

// Returns the lightmap layout of the scene's glTF file: second texture coordinates of all opaque surfaces. On
// one page where nothing overlaps, else on a page for each node. Returns nothing where it cannot be used;
// `why` then has the reason as half a sentence, and is empty where the file has no layout. metres_per_unit:
// as it was loaded. Throws InputError where the file is damaged.
std::optional<GivenLayout> round_trip_layout(const Scene& scene, const PatchSet& patches,
                                             double metres_per_unit, std::string& why);

}  // namespace luxel
