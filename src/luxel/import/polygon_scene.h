// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "luxel/core/context.h"
#include "luxel/import/load_scene.h"
#include "luxel/import/material_library.h"
#include "luxel/import/polygon_mesh.h"

namespace luxel {

// The scene of a mesh of polygons and the materials that its faces use. What was dropped or replaced becomes
// a warning, one per kind. Empty where the monitor stops the work.
Scene scene_of(const PolygonMesh& mesh, const MaterialLibrary& library, const std::string& source,
               const LoadOptions& options, const Context& context);

}  // namespace luxel
