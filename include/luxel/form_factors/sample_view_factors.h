// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/form_factors/view_elements.h"
#include "luxel/form_factors/view_factors.h"
#include "luxel/patch/patch_set.h"
#include "luxel/solution/solution.h"
#include "luxel/trace/tracer.h"

namespace luxel {

struct SampleFactorsOptions {
  std::uint64_t seed = 1;
  std::uint32_t replicates = 8;  ///< independent answers, 2 to 64, whose spread is the standard error
  /// Maximum per side of a patch: replicates times the largest power of two that fits, at least 1; smaller
  /// patches of an element get fewer by powers of two. 0: no limit.
  std::uint64_t rays = 0;
  double error = 0.001;  ///< stop at this root mean square standard error of the listed factors; 0: never
  /// Between patches: stop at this standard error of a whole row, see SampleFactorsReport; 0: never.
  double row_error = 0.0;
  double min_factor = 0.0;   ///< factors below are dropped; their sum is kept
  std::uint64_t memory = 0;  ///< bytes that factors may take; 0: no bound
  /// Later steps, for the prediction of memory: whether enforce_laws() follows, and the additional bytes per
  /// factor at the end.
  bool is_enforced = false;
  std::uint32_t bytes_beside = 0;
  std::vector<std::uint8_t> rows = {};  ///< [element]: whether its row is wanted; empty: all
};

struct SampleFactorsReport {
  std::uint64_t rays_per_side = 0;  ///< the most that any side had
  std::uint64_t rays = 0;           ///< traced, in all
  double error = 0.0;               ///< root mean square standard error of the listed factors
  /// Between patches: root mean square over rows of a row's root of the sum of squared standard errors, sinks
  /// too. It is the uncertainty of the power that a patch receives, in units of the spread of the radiosities
  /// around it: about 1 / sqrt(rays) for any number of patches.
  double row_error = 0.0;
  /// Memory of the factors while they are computed and used; number of listed factors, after any enforcement.
  std::uint64_t predicted_bytes = 0;
  std::uint64_t predicted_factors = 0;
  StopReason stop = StopReason::nothing_to_do;  ///< error_reached, ray_limit or stopped_by_user
};

/// View factors by counting: cosine rays from every side of a row's element, F_ij the fraction that meets
/// element j first (Sbert 1997's local lines; points as in trace/gather_rays.h). So factors, environment,
/// backs and dropped of a row sum to 1. Standard errors are those of the replicates' mean, from their spread.
/// Rays are doubled until the error is small enough; between groups, only in rows that need it.
///
/// Throws InputError, with figures, where the memory that the factors would take is beyond options.memory: it
/// is predicted from some rows before most rays are traced, within a few per cent. Empty if the monitor
/// stopped before there was a result. The same bits on any number of threads. Cost: one nearest hit per ray;
/// between patches about 20 bytes per listed factor while they are made, 16 afterwards.
std::optional<ViewFactors> sample_view_factors(const PatchSet& patches, const Tracer& tracer,
                                               const ViewElements& elements,
                                               const SampleFactorsOptions& options,
                                               SampleFactorsReport& report, const Context& context = {});

}  // namespace luxel
