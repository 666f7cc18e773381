// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "luxel/photometry/photometry.h"

namespace luxel {

// A plane through the aim: of type C the half planes C0 and C180, or C90 and C270; of types A and B the plane
// of vertical angle 0 (along X), or of horizontal angle 0 (along Y).
enum class MainPlane { x, y };

// cd in a main plane. angle: degrees from the aim, positive towards +X or +Y, -180 to 180.
double intensity_in_plane(const IntensityDistribution& intensity, MainPlane plane, double angle);

// The name of a main plane: "C0-C180", "C90-C270"; "horizontal", "vertical" of types A and B.
std::string name_of_plane(GoniometerType type, MainPlane plane);

struct PlaneFigures {
  double maximum = 0.0;  // cd, in this plane
  // Degrees between the outermost directions with at least 50 % (beam) and 10 % (field) of that maximum, on
  // its side of the horizontal, above or below; 0 where the plane has no light.
  double beam_angle = 0.0, field_angle = 0.0;
};

struct PhotometricFigures {
  double downward_fraction = 0.0;           // of the zonal flux: what leaves below the horizontal
  PlaneFigures x, y;                        // of MainPlane::x and y
  double vertical = 0.0, horizontal = 0.0;  // degrees: the file's angles of the maximum intensity
};

// Computes the figures of a luminaire's data sheet except its flux. Costs some milliseconds.
PhotometricFigures photometric_figures(const IntensityDistribution& intensity);

}  // namespace luxel
