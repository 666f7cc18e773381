// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/import/polygon_mesh.h"

namespace luxel {

struct PlyMesh {
  PolygonMesh mesh;                   // one material per texture, or one
  std::vector<std::string> textures;  // file names, by material; empty where the file has none
};

// Reads a PLY file: polygons and triangle strips, with normals, texture coordinates and colours. Returns
// nothing where the monitor stops the work. Coordinates are as in the file, `scale` metres per unit; colours
// of whole types are taken as sRGB, those of floats as linear. Throws InputError with source and line (in
// text) or byte (in binary files) where data are missing, an index is out of range, or a coordinate is not
// finite or lies beyond `farthest`.
std::optional<PlyMesh> read_ply(std::string_view bytes, const std::string& source, double scale,
                                const Context& context = {});

}  // namespace luxel
