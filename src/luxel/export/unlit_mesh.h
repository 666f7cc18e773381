// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "luxel/core/json.h"
#include "luxel/core/vector.h"
#include "luxel/export/quantise.h"
#include "luxel/import/gltf_writer.h"

namespace luxel {

// Adds POSITION and COLOR_0 and returns the attributes of a glTF primitive. Neither may be empty.
Json add_coloured_vertices(GltfWriter& file, std::span<const Vec3> positions,
                           std::span<const Rgba16> colours);

// Returns a material whose colours are final, so that no program lights it again (KHR_materials_unlit, which
// the file must list). Rough and not metallic, as the extension requires for programs without it.
Json unlit_material(const std::string& name, const Vec3& base_colour = Vec3(1.0f), bool two_sided = false);

// Adds the node as the root of the file's one scene, turned by turn_node_y_up().
void add_root(GltfWriter& file, Json node, const Vec3& up, const Vec3d& origin);

}  // namespace luxel
