// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/patch/patch_set.h"
#include "luxel/solution/solution.h"
#include "luxel/surface/smooth_light.h"

namespace luxel {

// The irradiance, summed over bands, W/m², up to which a side counts as hidden: a thousandth of the mean of
// all lit sides.
double hidden_irradiance(const PatchSet& patches, const Solution& solution);

// Gives the vertices of sides that almost no light reaches, such as a floor below a cupboard, the light of
// the lit sides at the same vertex: of those that continue in the plane, else of all. The edge between them
// is where the cupboard stands: a rasteriser, or a ray that slips past the edge, may show a pixel of what it
// hides, which must not be black. Vertices that a lit side uses keep their light, as do those where no other
// surface is, or passes through (PatchSet::contacts): there the edge is that of a hard shadow.
void light_hidden_vertices(const PatchSet& patches, const Solution& solution, SmoothLight& light);

}  // namespace luxel
