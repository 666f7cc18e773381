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
  double max_edge = 0.0;         // m, above 0: of the patches that are cut along the lines
  double detail = 0.0;           // m: scale of the shadow features to keep, at most max_edge; 0: max_edge
  double widest_penumbra = 0.0;  // m: of lines; 0: half of max_edge
  double contact_gap = 0.0;      // m, as for find_contact_lines()
  std::size_t max_contacts = 200'000;  // as for find_contact_lines()
  std::size_t max_patches = 0;         // that the lines may add; lines of little light are left out
};

// Finds the lines along which shadows end on surfaces: edges of the outline of things as seen from each
// light, projected from it onto the surfaces behind, where pairs of shadow rays find light on one side and
// none on the other (discontinuity meshing: Heckbert 1992; Lischinski, Tampieri and Greenberg 1992). A
// punctual light makes one line, where light ends. A sun with a disc, or a small lamp with a surface, makes
// two for each edge, where its penumbra begins and ends: as seen from the two vertices of the lamp that come
// first and last into sight past the edge. Positions are exact to rounding. Left out are penumbras wider than
// `widest_penumbra`, which patches follow by themselves, edges nearer to a lamp than three times its
// radius, lamps beyond find_lamp_bodies(), shadows of edges shorter than a twentieth of `detail`, those on
// triangles of less height, and cones of spots, which fade.
//
// triangles: the scene as make_patches() gives it with no_max_edge and without contacts, one patch per
// triangle; tracer: of these. The lines with the most light come first into max_patches; the result is sorted
// by triangle. The same bits for any number of threads. Empty without such lights, and after the monitor's
// stop in the stage "patches". Cost: that of find_contact_lines(), about 200 rays per line, and 0.1 us per
// triangle and light.
std::vector<ShadowLine> find_shadow_lines(const PatchSet& triangles, const Tracer& tracer,
                                          const ShadowLineOptions& options, const Context& context);

}  // namespace luxel
