// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/patch/patch_set.h"
#include "luxel/render/batch_means.h"
#include "luxel/render/light_paths.h"
#include "luxel/solution/solution.h"
#include "luxel/trace/tracer.h"

namespace luxel {

struct PathOptions {
  ReferenceLimits limits;
  BouncesFrom bounces_from = BouncesFrom::points;
  std::uint64_t seed = 1;  // another seed, another independent answer
};

// The report of a path-traced solution.
struct PathReport {
  StopReason stop = StopReason::nothing_to_do;
  bool complete = false;    // every side has light and an error; not if it was stopped at once
  std::uint64_t paths = 0;  // per side, maximum over sides
  std::uint64_t rays = 0;   // traced
  double predicted_error = 0.0;
  double error_95th = 0.0;
  // W, [band]. Power leaving a side escapes, or is lost at the backs of one-sided materials, in the share of
  // its first rays that do: exact where light is constant on each patch; the power from the sky and the power
  // that panes of glass absorb are found in this way. emitted + from_sky = absorbed + escaped + lost_at_backs
  // + in_panes, but for noise.
  std::vector<double> emitted, from_sky, absorbed, escaped, lost_at_backs, in_panes;
};

// Computes the reference for solvers: the irradiance of every patch side, the mean over random points of the
// side, by paths without a limit of bounces. Unbiased. With BouncesFrom::patches it converges to the
// radiosity solution of this very mesh, with BouncesFrom::points to the light that smaller patches would
// show.
//
// Fills everything in `solution` but its command line and options. Standard errors are widened by Student's t
// (see Solution); errors of different sides are independent. The same input and seed give the same bits on
// any number of threads. A stop from the monitor ends it in a fraction of a second with the samples so far.
// Cost: about four rays per path and bounce that counts; all sides take the same number of paths.
PathReport trace_light(const PatchSet& patches, const Tracer& tracer, Solution& solution,
                       const PathOptions& options, const Context& context = {});

}  // namespace luxel
