// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "luxel/core/context.h"
#include "luxel/import/polygon_mesh.h"

namespace luxel {

// The name of the material of faces that stand before any usemtl, and of the group before any g or o.
inline constexpr const char* default_name = "default";

// Reads the text of an OBJ file; returns nothing where the monitor stops the work, which it can a few times
// per megabyte. Coordinates are as in the file, `scale` metres per unit. Throws InputError with source and
// line for a coordinate that is not finite or lies beyond `farthest`, and for an index that is out of range.
// Reads about 130 MB per second.
std::optional<PolygonMesh> read_obj(std::string_view text, const std::string& source, double scale,
                                    const Context& context = {});

}  // namespace luxel
