// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "luxel/load/obj_mesh.h"

namespace luxel {

// The name of the material of faces that stand before any usemtl, and of the group before any g or o.
inline constexpr const char* default_name = "default";

// Reads the text of an OBJ file; coordinates are multiplied by scale. Throws InputError naming source and
// line for a coordinate that is no finite number and for an index that names nothing.
ObjMesh read_obj(std::string_view text, const std::string& source, float scale);

}  // namespace luxel
