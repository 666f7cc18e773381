// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "showpiece/mesh.h"
#include "showpiece/room.h"

namespace luxel::showpiece {

// The objects as Wavefront OBJ, one group each, its triangles sorted by paint, points shared within it (so
// that bent surfaces can be shaded smoothly); and the palette as MTL. Numbers: metres to the micrometre.
std::string obj_text(std::span<const Object> objects, std::span<const View> views,
                     const std::string& mtl_name);
std::string mtl_text();

// Writes the room as path (ending .obj) and its paints as the same path with the ending .mtl. detail: see
// reading_room().
void write_reading_room(const std::filesystem::path& path, int detail = 1);

}  // namespace luxel::showpiece
