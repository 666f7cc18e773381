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
  std::vector<Vec3> radiance;    // seen, in the gamut, W/(m² sr); with the mean of the picture
  std::vector<Vec3> irradiance;  // W/m²
};

// The reflectance of a surface: its material without the picture in the file, and the picture's mean, linear
// sRGB.
struct SurfaceColour {
  const BandMaterial& material;
  Vec3 picture = Vec3(1.0f);
};

// light: irradiance, [element][band], W/m²; RoundTripSurface::light has the vertices' elements. Vertex
// colours of the file tint the surface.
VertexColours vertex_colours(GltfFile& file, const RoundTripPart& part, const RoundTripSurface& surface,
                             const SurfaceColour& colour, const SideValues& light,
                             const BandColours& colours);

}  // namespace luxel
