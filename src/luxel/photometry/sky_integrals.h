// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "luxel/photometry/sky_model.h"
#include "luxel/photometry/sky_patches.h"

namespace luxel {

// Illuminances of unobstructed planes by the sky alone, without the sun and the ground: lx where luminances
// are cd/m².
struct SkyIlluminances {
  double horizontal = 0.0;                                  // of the ground
  double north = 0.0, east = 0.0, south = 0.0, west = 0.0;  // of vertical planes that face these directions
};

// Those of a sky whose luminances are model.relative_luminance(). Quadrature; relative error below 1e-7.
// Cost: 0.5 ms.
SkyIlluminances relative_illuminances(const SkyModel& model);

// Luminance of the ground, cd/m², of diffuse reflectance `albedo`. horizontal_illuminance: by sky and sun,
// lx.
double ground_luminance(double albedo, double horizontal_illuminance);

struct SkyLevel {
  double horizontal_illuminance = 0.0;         // by the sky, lx
  double direct_horizontal_illuminance = 0.0;  // by the sun, lx: only the ground is brighter by it
  double ground_albedo = 0.2;                  // diffuse reflectance of the ground
};

// The mean luminance of every patch, cd/m²: [patch]. Within each patch the mean over its solid angle is taken
// by quadrature; then all are scaled so that the sum of luminance times projected solid angle over the
// patches above the horizon is the horizontal illuminance. Patches below the horizon have the ground's
// luminance. The sun is in no patch. Throws InputError where a sky without any light should have some, and
// where `patches` is one patch of all directions. Cost: 1.5 µs per patch, and 0.3 ms.
std::vector<double> sky_patch_luminances(const SkyModel& model, const SkyPatches& patches,
                                         const SkyLevel& level);
// Does the same without a sun.
std::vector<double> sky_patch_luminances(const SkyModel& model, const SkyPatches& patches,
                                         double horizontal_illuminance, double ground_albedo);

}  // namespace luxel
