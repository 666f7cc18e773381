// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "luxel/core/context.h"
#include "luxel/import/polygon_mesh.h"

namespace luxel {

// Reads an STL file, text or binary. Corners at equal positions become one vertex. In text, the names of
// solids become groups and objects. Normals are ignored: the order of the corners gives the front. Returns
// nothing where the monitor stops the work. Coordinates are as in the file, `scale` metres per unit. Throws
// InputError with source and line (in text) or triangle (in binary files) for a coordinate that is not finite
// or lies beyond `farthest`, and where the file is cut off.
std::optional<PolygonMesh> read_stl(std::string_view bytes, const std::string& source, double scale,
                                    const Context& context = {});

}  // namespace luxel
