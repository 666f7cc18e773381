// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "luxel/core/workers.h"
#include "luxel/form_factors/shaft_search.h"
#include "luxel/patch/patch_set.h"
#include "luxel/trace/tracer.h"

namespace luxel {

struct FormFactor {
  double value = 0.0;  // [0, 1]
  double error = 0.0;  // absolute: an estimate, in practice an upper bound; see FormFactors
  bool exact = true;   // closed form: nothing reaches between the two, or they do not face each other
};

// Form factors between two patch sides, with what stands between them. Side 2p is the front of patch p,
// 2p + 1 its back; every patch hides what is behind it from both of its sides.
//
// Nothing is left to rays alone to decide. All patches that reach into the shaft between the two
// (ShaftSearch) are found, by more than a slack of 5e-7 of the scene's largest coordinate, the rounding of
// its floats. There are none: the closed form (polygon_form_factor), exact to 1e-12. Up to 200: the integral
// with exact visibility at each point, cut until it is as good as asked for (obstructed_exchange). More:
// shadow rays (ray_exchange), and error is three standard errors. Patches may touch and share edges. Of a
// patch without area the factor is 0.
//
// Read-only after it was made; any number of threads may ask, and the answer depends on the question alone.
class FormFactors {
 public:
  // Keeps references to patches and tracer. 0.3 s and 75 MB per million patches.
  FormFactors(const PatchSet& patches, const Tracer& tracer, const Workers& workers);

  // The share of the power leaving `from` that arrives at `to`. tolerance: absolute, above 0; what cannot be
  // reached in 20,000 cells or a million rays is left, and `error` says so. 10 us where nothing is between;
  // else 1 ms, 10 ms at a tolerance of 1e-6, and 1 s at worst.
  FormFactor between(std::size_t from, std::size_t to, double tolerance) const;

 private:
  const PatchSet& patches_;
  const Tracer& tracer_;
  ShaftSearch search_;
  double slack_ = 0.0;  // m
};

}  // namespace luxel
