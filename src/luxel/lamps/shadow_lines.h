// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/patch/make_patches.h"
#include "luxel/patch/patch_set.h"
#include "luxel/trace/tracer.h"

namespace luxel {

struct ShadowLineOptions {
  double max_edge = 0.0;               // m, above 0: of the patches that are cut along the lines
  double contact_gap = 0.0;            // m, as for find_contact_lines()
  std::size_t max_contacts = 200'000;  // as for find_contact_lines()
  std::size_t max_patches = 0;         // that the lines may add; lines of little light are left out
};

// Finds the lines along which hard shadows of punctual lights end on surfaces: edges of the outline of
// things as seen from each light, projected from it onto the surfaces behind, where pairs of shadow rays find
// light on one side and none on the other (discontinuity meshing, D0: Heckbert 1992; Lischinski, Tampieri and
// Greenberg 1992). Positions are exact to rounding. Shadows of edges shorter than a twentieth of max_edge,
// and those on triangles of less height, are left out; so are cones of spots, which fade.
//
// triangles: the scene as make_patches() gives it with no_max_edge and without contacts, one patch per
// triangle; tracer: of these. The lines with the most light per length come first into max_patches; the
// result is sorted by triangle. The same bits for any number of threads. Empty without punctual lights, and
// after the monitor's stop in the stage "patches". Cost: that of find_contact_lines(), and about 200 rays per
// line.
std::vector<ShadowLine> find_shadow_lines(const PatchSet& triangles, const Tracer& tracer,
                                          const ShadowLineOptions& options, const Context& context);

}  // namespace luxel
