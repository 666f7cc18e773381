// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "luxel/form_factors/occluders.h"
#include "luxel/form_factors/shaft_search.h"
#include "luxel/patch/patch_set.h"
#include "luxel/patch/side.h"
#include "luxel/trace/tracer.h"

namespace luxel {

struct FormFactor {
  double value = 0.0;  // [0, 1]
  double error = 0.0;  // absolute: an estimate, in practice an upper bound; see FormFactors
  bool exact = true;   // closed form: all is seen, one occluder hides all, or they do not face each other
};

// Form factors between two patch sides, with occlusion. Side 2p is the front of patch p, 2p + 1 its back;
// every patch occludes from both of its sides.
//
// Finds all occluders that reach into the shaft between the two (ShaftSearch) by more than a slack of 5e-7 of
// the scene's largest coordinate, the rounding of its floats; the choice of method does not depend on rays
// alone. Without occluders: the closed form (polygon_form_factor), exact to 1e-12. Where a single one hides
// each from the other: 0. Up to 200 occluders: the integral with exact visibility at each point, refined to
// the tolerance (obstructed_exchange). More: shadow rays (ray_exchange), and error is three standard errors.
// Patches may touch and share edges. The factor of a patch without area is 0.
//
// Read-only after construction; any number of threads may call, and the result depends on the arguments
// alone.
class FormFactors {
 public:
  // Keeps references to patches and tracer. 20 s per million patches.
  FormFactors(const PatchSet& patches, const Tracer& tracer);

  // Returns the share of the power leaving `from` that arrives at `to`. tolerance: absolute, above 0; where
  // it is not reached within 20,000 cells or a million rays, `error` holds the error that remains. Costs 10
  // us without occluders; else 1 ms, 10 ms at a tolerance of 1e-6, and 1 s at worst.
  FormFactor between(SideId from, SideId to, double tolerance) const;

 private:
  const PatchSet& patches_;
  const Tracer& tracer_;
  double slack_;  // m
  Occluders occluders_;
  ShaftSearch search_;
};

}  // namespace luxel
