// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/core/vector.h"
#include "luxel/photometry/instant.h"

namespace luxel {

inline constexpr double sun_diameter = 0.533;  // apparent, degrees, the mean over a year

// A place on the earth, degrees.
struct Site {
  double latitude = 0.0;   // north of the equator
  double longitude = 0.0;  // east of Greenwich
};

// State of the atmosphere, which refracts the sun's rays.
struct Atmosphere {
  double pressure = 1010.0;   // hPa; 0: no refraction
  double temperature = 10.0;  // °C
};

// Apparent position of the centre of the sun.
struct SunPosition {
  double elevation = 0.0;                  // degrees above the horizon
  double azimuth = 0.0;                    // degrees from north to the east, [0, 360)
  Vec3d direction = Vec3d(0.0, 1.0, 0.0);  // unit; x east, y north, z zenith
  double distance = 1.0;                   // astronomical units

  // Irradiance outside the atmosphere over its mean over the year.
  double orbit_factor() const { return 1.0 / (distance * distance); }
};

// J. Meeus, "Astronomical Algorithms", second edition 1998, chapters 12, 13, 22, 25 (low accuracy, with five
// periodic terms of the planets and the moon) and 40 (parallax). Refraction by Sæmundsson (chapter 16) where
// the sun's true elevation is above -0.84 degrees: below, its upper edge is under the horizon. Error of the
// direction below 0.005 degrees from 1950 to 2050, and 0.03 from 1700 to 2300, where the rotation of the
// earth differs from the constant 69 s that is used here. Cost: 0.7 µs.
SunPosition sun_position(Instant instant, const Site& site, const Atmosphere& atmosphere = {});

// The unit vector of an elevation and an azimuth, degrees, in local axes; and back.
Vec3d direction_towards(double elevation, double azimuth);
double elevation_of(const Vec3d& direction);  // [-90, 90]
double azimuth_of(const Vec3d& direction);    // [0, 360); 0 at the zenith

}  // namespace luxel
