// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "luxel/photometry/luminaire_mesh.h"

namespace luxel {

// A part of a luminous opening that looks about one way.
struct OpeningFace {
  LuminaireMesh mesh;     // local axes
  double radiance = 0.0;  // 1/m², above 0; relative to the largest intensity, as relative_radiance()
};

// The opening as diffuse surfaces, as displays show it that know no distribution: each face has the flux that
// leaves through it, so that a pendant is brighter above than below if its light goes up, and one of a flat
// opening that emits to one side is not seen from the other. A flat opening has two faces, whose places are
// `apart` m from each other, so that rays meet the nearer one; bodies have one downwards, one of the sides
// and one upwards. Faces that emit nothing are left out. Costs some milliseconds.
std::vector<OpeningFace> opening_faces(const Photometry& photometry, double apart);

}  // namespace luxel
