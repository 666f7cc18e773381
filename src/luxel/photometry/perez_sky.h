// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "luxel/core/vector.h"
#include "luxel/photometry/sky_model.h"

namespace luxel {

struct PerezInput {
  double direct_normal = 0.0;       // irradiance of a plane that faces the sun, by the sun, W/m²
  double diffuse_horizontal = 0.0;  // irradiance of the ground by the sky, W/m²
  double dew_point = 11.0;          // °C; the default is that of Radiance's gendaymtx
  // Irradiance outside the atmosphere over its mean over the year: (mean distance of the sun / its
  // distance)².
  double orbit_factor = 1.0;
};

// The sky and the sun's light by irradiances.
struct PerezSky {
  SkyModel model;
  double diffuse_illuminance = 0.0;        // of the ground by the sky, lx
  double direct_normal_illuminance = 0.0;  // of a plane that faces the sun, by the sun, lx

  double clearness = 1.0;                 // epsilon, at least 1
  double brightness = 0.01;               // Delta, 0.01 to 0.6
  int bin = 1;                            // 1 (overcast) to 8 (clear), by clearness
  std::array<double, 5> parameters = {};  // a, b, c, d, e of the luminance distribution
};

// The all-weather sky of R. Perez, R. Seals, J. Michalsky, Solar Energy 50(3) and 51(5) 423 (erratum), 1993,
// with the luminous efficacies of R. Perez et al., Solar Energy 44(5), 1990, table 4. sun: unit, local axes.
//
// Programs limit the inputs in different ways. Here: irradiances below 0 count as 0; the sun's zenith angle
// is at most 90 degrees, and has no lower limit (gendaymtx: 3); clearness is at least 1 and has no upper
// limit, since only its bin counts; brightness is within [0.01, 0.6], and for the distribution at least 0.2
// where clearness is between 1.065 and 2.8; b is at most 0; a negative luminance is 0; a distribution that is
// 0 in all directions is replaced by the uniform one; efficacies are at least 0. Without light from the sky
// the model is uniform.
PerezSky perez_sky(const PerezInput& input, const Vec3d& sun);

}  // namespace luxel
