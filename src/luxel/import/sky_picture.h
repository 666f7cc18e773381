// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "luxel/core/vector.h"
#include "luxel/photometry/sky_patches.h"

namespace luxel {

// A bright spot of a picture of the surroundings: its sun, or a lamp.
struct SkySpot {
  Vec3d towards{0.0};           // unit, local axes: east, north, zenith
  double angular_radius = 0.0;  // rad: of a disc of the solid angle that its bright pixels have
  Vec3 irradiance{0.0f};        // W/m², linear sRGB, of a plane that faces it
};

struct SkyPicture {
  std::vector<Vec3> radiance;  // [sky patch], W/(m² sr), linear sRGB: without the spots
  std::vector<SkySpot> spots;  // at most 8
};

// An equirectangular picture as a sky: its left edge is north, its centre south, and its left half the east.
// It is scaled so that open ground has this illuminance by its upper half, lx; 0: its values are W/(m² sr).
// The mean over each patch is taken over its pixels. A pixel with a hundred times the radiance of the sky in
// the mean is part of a spot; pixels nearer than 6 degrees to the brightest one of a spot belong to it.
// Throws InputError where the file cannot be read, or has no light where some was expected.
SkyPicture read_sky_picture(const std::filesystem::path& path, const SkyPatches& patches,
                            double horizontal_illuminance);

}  // namespace luxel
