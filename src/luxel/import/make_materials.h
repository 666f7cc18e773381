// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "luxel/core/context.h"
#include "luxel/import/load_scene.h"
#include "luxel/import/material_library.h"

namespace luxel {

// Reflectance of surfaces that no file describes: a middle grey.
inline constexpr float default_reflectance = 0.5f;

// Limit of the reflectance that a mirror or metal gets instead of its reflections: that of aluminium and
// silver is 0.9, and a diffuse surface that bright looks like paint.
inline constexpr float max_metal_reflectance = 0.8f;

// Creates one Material of the scene for each name that faces use, in their order, from the library, and the
// textures that these use. Missing materials and unsupported properties become a warning, one per kind.
void make_materials(std::span<const NamedLine> used, const MaterialLibrary& library,
                    const LoadOptions& options, Scene& scene, const Context& context);

}  // namespace luxel
