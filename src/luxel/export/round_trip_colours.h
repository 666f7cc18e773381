// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "luxel/core/vector.h"
#include "luxel/export/round_trip_surfaces.h"
#include "luxel/import/gltf_file.h"
#include "luxel/patch/side.h"
#include "luxel/scene/band_colours.h"
#include "luxel/scene/scene.h"

namespace luxel {

// Light at the vertices of a surface, in linear sRGB; black where it is unknown.
struct VertexColours {
  std::vector<Vec3> radiance;    // seen, in the gamut, W/(m² sr)
  std::vector<Vec3> irradiance;  // W/m²
};

// light: irradiance, [element][band], W/m²; RoundTripSurface::light has the vertices' elements. material:
// that of the surface, without what textures in the file add. Vertex colours of the file tint it.
VertexColours vertex_colours(GltfFile& file, const RoundTripPart& part, const RoundTripSurface& surface,
                             const BandMaterial& material, const SideValues& light,
                             const BandColours& colours);

}  // namespace luxel
