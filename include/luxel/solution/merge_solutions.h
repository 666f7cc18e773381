// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "luxel/solution/solution_file.h"

namespace luxel {

/// A solution with the name of where it came from, for messages.
struct NamedSolution {
  std::string name;
  Baked baked;
};

/// Merges independent solutions of the same patches: sampled runs with different seeds, or solutions merged
/// from such runs. Light is the mean weighted by rays; its variance is that of such a mean; the bias of
/// sharing, which may be the same in all runs, is not assumed to cancel; and the widening of standard errors
/// is that of all degrees of freedom together (Welch 1947). Any order gives the same bytes.
///
/// Throws InputError naming the file where there are fewer than two, or one is of another scene, other
/// patches or another method, has no standard errors, or is made with random numbers that another one is made
/// with as well (a run merged with itself would state a smaller error without having it).
Baked merge_solutions(std::vector<NamedSolution> solutions);

}  // namespace luxel
