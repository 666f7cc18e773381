// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "luxel/core/progress.h"
#include "luxel/core/workers.h"
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

// What a path-traced solution has to say beside the light.
struct PathReport {
  StopReason stop = StopReason::nothing_to_do;
  bool complete = false;    // every side has light and an error; not if it was stopped at once
  std::uint64_t paths = 0;  // a side, of the side that has most
  std::uint64_t rays = 0;   // traced
  double predicted_error = 0.0;
  double error_95th = 0.0;
  // W, [band]. What leaves a side escapes, or is lost at the backs of one-sided materials, in the share of
  // its first rays that do: exact where light is constant on each patch; so does the sky's light come.
  // emitted + from_sky = absorbed + escaped + lost, but for noise.
  std::vector<double> emitted, from_sky, absorbed, escaped, lost_at_backs;
};

// The truth that solvers are held against: the irradiance of every patch side, the mean over random points of
// the side, by paths that no number of bounces ends. Unbiased. With BouncesFrom::patches it converges to the
// radiosity solution of this very mesh, with BouncesFrom::points to the light that smaller patches would
// show.
//
// Fills everything in `solution` but its command line and options. Standard errors are widened as Student's t
// is (see Solution); errors of different sides are independent. The same input and seed give the same bits on
// any number of threads. A stop from the monitor ends it in a fraction of a second with what there is. Cost:
// about four rays per path and bounce that counts; each side takes as many paths as each other.
PathReport trace_light(const PatchSet& patches, const Tracer& tracer, Solution& solution,
                       const PathOptions& options, const Workers& workers, const Monitor& monitor = {});

}  // namespace luxel
