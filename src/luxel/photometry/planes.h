// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "luxel/photometry/photometry.h"

namespace luxel {

// Planes of a distribution of type C: horizontal angles in degrees, ascending, and candela,
// [horizontal][vertical].
struct Planes {
  std::vector<double> horizontal;
  std::vector<double> candela;
};

// Brings the ranges of horizontal angles that files have to those that IntensityDistribution takes: a half or
// a quadrant that begins elsewhere than at 0 is turned or mirrored, which changes no direction's intensity.
// Returns a sentence with the assumption where the range is none of the standard's, else an empty one. Throws
// InputError where it makes no sense.
std::string standardise(Planes& planes);

// The same distribution with planes all around, 0 to 360 degrees, turned by `turn` degrees anticlockwise seen
// from above: exactly, since intensity is linear between planes.
Planes all_around(const IntensityDistribution& distribution, double turn);

// Turns angles and opening of a luminaire. Returns a sentence where the opening could not follow; empty: it
// did. Throws InputError for types A and B unless `turn` is a multiple of 90.
std::string turn_luminaire(Photometry& photometry, double turn);

}  // namespace luxel
