// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "luxel/core/progress.h"
#include "luxel/import/obj_mesh.h"

namespace luxel {

// The name of the material of faces that stand before any usemtl, and of the group before any g or o.
inline constexpr const char* default_name = "default";

// Reads the text of an OBJ file; nothing where the monitor says stop, which it can a few times a megabyte.
// Coordinates are as the file has them, `scale` metres per unit. Throws InputError naming source and line for
// a coordinate that is no finite number or lies beyond `farthest`, and for an index that names nothing. Reads
// about 130 MB per second.
std::optional<ObjMesh> read_obj(std::string_view text, const std::string& source, double scale,
                                const Monitor& monitor = {});

}  // namespace luxel
